// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace radcert {

/// The names of temporary files that a process has open, where a signal handler finds them.
/// Source    POSIX signal-safety(7): a handler may touch lock-free atomics and call unlink(2)
/// Result    while a TemporaryName lives, remove_temporary_files() removes its file
/// Limits    256 names of at most 4095 bytes at a time; further or longer ones are not known to it
class TemporaryName {
public:
  explicit TemporaryName(std::string_view name);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

private:
  std::size_t slot_;
};

/// Removes the temporary files that are known; safe in a signal handler.
void remove_temporary_files() noexcept;

/// While one lives, files that belong together are being renamed: a handler lets them be.
class RenamingFiles {
public:
  RenamingFiles();
  ~RenamingFiles();
  RenamingFiles(const RenamingFiles&) = delete;
  RenamingFiles& operator=(const RenamingFiles&) = delete;
};

/// Whether one lives; safe in a signal handler.
[[nodiscard]] bool renaming_files() noexcept;

}  // namespace radcert
