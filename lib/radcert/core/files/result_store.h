// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"

#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace radcert {

/// Keeps results of earlier runs, found by the full text of what was computed.
/// Maths     none; the file name is SHA-256 of the key, and the file repeats the key
/// Source    NIST FIPS 180-4
/// Requires  the key says everything that the content depends on: inputs, budget, version
/// Result    get() gives a content that put() stored under exactly this key, or nothing: the whole key is
///           compared, and a truncated, altered or foreign file, or one of another layout, reads as absent.
///           Writing is atomic; several processes and threads may share a folder
/// Limits    a checksum, not a signature: it does not resist forgery. Never throws for a failing disk: the
///           store switches itself off, status() says why
class ResultStore {
public:
  /// A store in this folder, which is made when first needed.
  explicit ResultStore(std::filesystem::path folder);
  /// $RADCERT_STORE, else $XDG_CACHE_HOME/radcert, else $HOME/.cache/radcert, else a store that is off.
  ResultStore();
  /// A store that keeps nothing.
  [[nodiscard]] static ResultStore none(std::string reason);

  /// From now on get() gives only what this object has put().
  void ignore_earlier();

  ResultStore(ResultStore&& other) noexcept;
  ResultStore& operator=(ResultStore&&) = delete;

  [[nodiscard]] std::optional<std::string> get(std::string_view key) const;
  /// Stores the content; the reason where it could not, after which the store is off for writing.
  Outcome<void> put(std::string_view key, std::string_view content);
  /// Whether put() is still tried, else the reason.
  [[nodiscard]] Outcome<void> status() const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// The file that holds, or would hold, the result of a key.
  [[nodiscard]] std::filesystem::path file(std::string_view key) const;

private:
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::optional<std::string> off_;
  std::optional<std::set<std::filesystem::path>>
      own_;  ///< the files of put(), where earlier ones are ignored
};

/// $RADCERT_STORE, else $XDG_CACHE_HOME/radcert, else $HOME/.cache/radcert; no value where none of the three
/// is set.
[[nodiscard]] std::optional<std::filesystem::path> default_store_folder();

}  // namespace radcert
