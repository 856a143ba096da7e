// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/files/result_store.h"

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"

#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace radcert {

namespace {

// The number names this layout; records of another are not read.
constexpr std::string_view magic = "radcert result 2\n";

/// magic, "<key length> <content length> <SHA-256 of key and content>\n", key, content.
std::string record(std::string_view key, std::string_view content) {
  std::string both(key);
  both.append(content);
  std::string out(magic);
  out.append(std::to_string(key.size())).append(" ").append(std::to_string(content.size())).append(" ");
  out.append(sha256(both)).append("\n").append(both);
  return out;
}

std::optional<std::string> content_of(std::string_view file, std::string_view key) {
  if (!file.starts_with(magic)) return std::nullopt;
  const std::string_view rest = file.substr(magic.size());
  const std::size_t line = rest.find('\n');
  if (line == std::string_view::npos) return std::nullopt;
  const std::string_view body = rest.substr(line + 1);
  if (!body.starts_with(key)) return std::nullopt;
  std::string content(body.substr(key.size()));
  if (record(key, content) != file) return std::nullopt;
  return content;
}

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

constexpr std::uint64_t largest_record = std::uint64_t{1} << 30;

}  // namespace

std::optional<std::filesystem::path> default_store_folder() {
  if (std::string own = environment("RADCERT_STORE"); !own.empty()) return std::filesystem::path(own);
  // The XDG specification has relative paths ignored.
  if (const std::filesystem::path cache = environment("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "radcert";
  if (const std::filesystem::path home = environment("HOME"); home.is_absolute())
    return home / ".cache" / "radcert";
  return std::nullopt;
}

ResultStore::ResultStore(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) off_ = "no folder is given";
}

ResultStore::ResultStore() {
  if (auto folder = default_store_folder()) {
    folder_ = std::move(*folder);
  } else {
    off_ = "none of RADCERT_STORE, XDG_CACHE_HOME and HOME is set";
  }
}

ResultStore ResultStore::none(std::string reason) {
  ResultStore store{std::filesystem::path()};
  store.off_ = std::move(reason);
  return store;
}

ResultStore::ResultStore(ResultStore&& other) noexcept
    : folder_(std::move(other.folder_)), off_(std::move(other.off_)), own_(std::move(other.own_)) {}

void ResultStore::ignore_earlier() {
  const std::scoped_lock lock(mutex_);
  if (!own_) own_.emplace();
}

std::filesystem::path ResultStore::file(std::string_view key) const {
  return folder_ / (sha256(key) + ".radcert");
}

std::optional<std::string> ResultStore::get(std::string_view key) const {
  if (folder_.empty()) return std::nullopt;
  try {
    const std::filesystem::path path = file(key);
    {
      const std::scoped_lock lock(mutex_);
      if (own_ && !own_->contains(path)) return std::nullopt;
    }
    if (!std::filesystem::is_regular_file(path)) return std::nullopt;
    return content_of(read_file(path, largest_record), key);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const EnvironmentError&) {
    return std::nullopt;
  } catch (const std::filesystem::filesystem_error&) {
    return std::nullopt;
  }
}

Outcome<void> ResultStore::put(std::string_view key, std::string_view content) {
  {
    const std::scoped_lock lock(mutex_);
    if (off_) return because(*off_);
  }
  const std::string text = record(key, content);
  if (text.size() > largest_record) return because("the result is too large to be stored");
  std::string reason;
  try {
    std::filesystem::create_directories(folder_);
    const std::filesystem::path path = file(key);
    write_atomically(path, text);
    const std::scoped_lock lock(mutex_);
    if (own_) own_->insert(path);
    return {};
  } catch (const EnvironmentError& error) {
    reason = error.what();
  } catch (const std::filesystem::filesystem_error& error) {
    reason = EnvironmentError(folder_.string(), error.code().message()).what();
  }
  const std::scoped_lock lock(mutex_);
  if (!off_) off_ = reason;
  return because(reason);
}

Outcome<void> ResultStore::status() const {
  const std::scoped_lock lock(mutex_);
  if (off_) return because(*off_);
  return {};
}

}  // namespace radcert
