// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace radcert {

/// Writes a file as a whole or not at all.
/// Source    POSIX rename(2): replacing is atomic within a folder
/// Requires  a file name (else InputError) in a folder that exists and can be written
/// Result    the file has the content and is on the disk; on failure EnvironmentError names the path and the
///           reason, the old file is unchanged and no temporary is left. The rights of an old file are kept,
///           a symbolic link is followed
/// Limits    a process killed by SIGKILL may leave one `.<name>.<process>.<n>.tmp`, never half a file; a
///           device or pipe is written directly, which is not atomic
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for a content that comes piece by piece and need not be held in memory.
/// Requires  as write_atomically
/// Result    the file is there, as a whole, once keep() has returned; without it, or after a failure, the old
///           file is unchanged and no temporary is left
class AtomicFile {
public:
  /// Nothing is opened before the first piece.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  void put(std::string_view piece);
  /// All of it is on the disk, under another name: what may fail for want of room has not failed.
  void finish();
  void keep();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  struct Open;
  void open();
  std::filesystem::path path_;
  std::unique_ptr<Open> open_;
};

/// Writes files as wholes, all of them or none.
/// Requires  as write_atomically, of each; `with_them` is a file that has been put piece by piece
/// Result    every content is on the disk before the first file gets its name; on failure until then
///           EnvironmentError, the old files are unchanged and no temporary is left. Of processes that write
///           into the same folders at the same time all files are those of one of them
/// Limits    one that is killed between two renamings, or meets a folder that is taken away meanwhile, leaves
///           some old files beside new ones, each whole; where a file system has no flock(2), or a lock is
///           held for ten seconds, files of two processes may stand side by side
void write_together(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
                    AtomicFile* with_them = nullptr);

/// The content of a file that the user named.
/// Requires  nothing
/// Result    the bytes; InputError where the file is missing, unreadable, a folder or longer than the limit;
///           EnvironmentError where the device fails
/// Limits    no more than limit_bytes + 1 bytes are read; all of it is held in memory
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::uint64_t limit_bytes = std::uint64_t{64} << 20);

}  // namespace radcert
