// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/files/atomic_file.h"

#include "radcert/core/errors.h"
#include "radcert/core/files/temporary_files.h"
#include "radcert/core/interrupt.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace radcert {

namespace {

std::string reason_of(int error) { return std::generic_category().message(error); }

/// The system would read such a name up to the null byte, as another file.
bool has_null(const std::filesystem::path& path) { return path.native().find('\0') != std::string::npos; }

class Descriptor {
public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  /// Closes now; 0 or the error.
  int close() {
    const int closed = ::close(number_);
    number_ = -1;
    return closed == 0 || errno == EINTR ? 0 : errno;
  }

private:
  int number_;
};

/// 0 or the error.
int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int flush_to_disk(int descriptor) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINTR) continue;
    // A file system without fsync has nothing to flush.
    return errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
  }
  return 0;
}

/// A temporary file beside its target, removed unless kept.
class Temporary {
public:
  Temporary(const std::filesystem::path& target, mode_t rights) {
    static std::atomic<unsigned long> next{0};
    const std::filesystem::path folder = target.parent_path().empty() ? "." : target.parent_path();
    // Short enough for a file name whatever the target is called.
    const std::string stem = target.filename().string().substr(0, 100);
    for (int attempt = 0; attempt < 1000; ++attempt) {
      name_ =
          folder / ("." + stem + "." + std::to_string(::getpid()) + "." + std::to_string(next++) + ".tmp");
      known_.emplace(name_.native());
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, rights);
      if (descriptor_ >= 0 || errno != EEXIST) break;
    }
    error_ = descriptor_ >= 0 ? 0 : errno;
  }
  ~Temporary() {
    if (descriptor_ >= 0 && !kept_) ::unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] int error() const { return error_; }
  [[nodiscard]] const std::filesystem::path& name() const { return name_; }
  void keep() { kept_ = true; }

private:
  std::filesystem::path name_;
  std::optional<TemporaryName> known_;
  int descriptor_ = -1;
  int error_ = 0;
  bool kept_ = false;
};

}  // namespace

/// The file while it is written: a temporary, or what the path names where that is a device or a pipe.
struct AtomicFile::Open {
  std::filesystem::path target;
  std::optional<mode_t> old_rights;
  std::optional<Temporary> temporary;
  std::optional<Descriptor> out;
  bool finished = false;
};

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)) {}
AtomicFile::~AtomicFile() = default;

void AtomicFile::open() {
  if (open_) return;
  if (path_.filename().empty() || has_null(path_))
    throw InputError({.value = path_.string(), .problem = "is not a file name"});
  auto opened = std::make_unique<Open>();
  opened->target = path_;
  struct stat status {};
  if (::stat(path_.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) throw EnvironmentError(path_.string(), "cannot be written: it is a folder");
    if (!S_ISREG(status.st_mode)) {
      opened->out.emplace(::open(path_.c_str(), O_WRONLY | O_CLOEXEC));
      if (opened->out->number() < 0)
        throw EnvironmentError(path_.string(), "cannot be opened for writing: " + reason_of(errno));
      open_ = std::move(opened);
      return;
    }
    opened->old_rights = status.st_mode & 07777U;
    std::error_code failed;
    if (std::filesystem::path resolved = std::filesystem::canonical(path_, failed); !failed)
      opened->target = resolved;
  }
  opened->temporary.emplace(opened->target, 0666);
  if (opened->temporary->error() != 0)
    throw EnvironmentError(path_.string(), "cannot be written: " + reason_of(opened->temporary->error()));
  opened->out.emplace(opened->temporary->descriptor());
  open_ = std::move(opened);
}

void AtomicFile::put(std::string_view piece) {
  open();
  if (const int error = write_all(open_->out->number(), piece); error != 0)
    throw EnvironmentError(path_.string(), "cannot be written: " + reason_of(error));
}

void AtomicFile::finish() {
  open();
  Open& file = *open_;
  if (file.finished) return;
  const int descriptor = file.out->number();
  int error = 0;
  if (file.old_rights && ::fchmod(descriptor, *file.old_rights) != 0) error = errno;
  if (error == 0 && file.temporary) error = flush_to_disk(descriptor);
  const int closing = file.out->close();
  if (error == 0) error = closing;
  if (error != 0) throw EnvironmentError(path_.string(), "cannot be written: " + reason_of(error));
  file.finished = true;
}

void AtomicFile::keep() {
  finish();
  Open& file = *open_;
  if (!file.temporary) return;
  if (std::rename(file.temporary->name().c_str(), file.target.c_str()) != 0)
    throw EnvironmentError(path_.string(), "cannot be written: " + reason_of(errno));
  file.temporary->keep();

  // The name, too, is to survive a power cut; where the folder cannot be flushed the file is complete all the
  // same.
  const std::filesystem::path folder = file.target.parent_path().empty() ? "." : file.target.parent_path();
  const Descriptor holder(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (holder.number() >= 0) flush_to_disk(holder.number());
}

void write_atomically(const std::filesystem::path& path, std::string_view content) {
  AtomicFile file(path);
  file.put(content);
  file.keep();
}

namespace {

/// Folders that no other process renames files in, as far as it asks first. Where the file system has no
/// locks, or one is held for long, it goes on without: a lock keeps files together, it does not keep them
/// whole.
class HeldFolders {
public:
  explicit HeldFolders(const std::vector<std::filesystem::path>& folders) {
    constexpr int tries = 1000;
    constexpr std::chrono::milliseconds between(10);
    for (const std::filesystem::path& folder : folders) {
      Descriptor& held = *held_.emplace_back(
          std::make_unique<Descriptor>(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)));
      for (int k = 0; k < tries && held.number() >= 0; ++k) {
        if (::flock(held.number(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) break;
        throw_if_interrupted();
        std::this_thread::sleep_for(between);
      }
    }
  }

private:
  std::vector<std::unique_ptr<Descriptor>> held_;
};

}  // namespace

void write_together(const std::vector<std::pair<std::filesystem::path, std::string>>& files,
                    AtomicFile* with_them) {
  const auto folder_of = [](const std::filesystem::path& path) {
    return path.parent_path().empty() ? std::filesystem::path(".") : path.parent_path();
  };
  std::vector<std::unique_ptr<AtomicFile>> written;
  std::vector<std::filesystem::path> folders;
  for (const auto& [path, content] : files) {
    written.push_back(std::make_unique<AtomicFile>(path));
    written.back()->put(content);
    written.back()->finish();
    folders.push_back(folder_of(path));
  }
  if (with_them != nullptr) {
    with_them->finish();
    folders.push_back(folder_of(with_them->path()));
  }
  // In one order for all processes, so that none waits for another that waits for it.
  std::sort(folders.begin(), folders.end());
  folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
  const HeldFolders held(folders);
  const RenamingFiles renaming;
  for (const auto& file : written) file->keep();
  if (with_them != nullptr) with_them->keep();
}

std::string read_file(const std::filesystem::path& path, std::uint64_t limit_bytes) {
  const auto wrong = [&](const std::string& problem, const std::string& allowed = {}) {
    return InputError({.source = path.string(), .problem = problem, .allowed = allowed});
  };
  if (has_null(path)) throw wrong("is not a file name");
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.number() < 0) {
    const int error = errno;
    if (error == EMFILE || error == ENFILE || error == EIO || error == ENOMEM)
      throw EnvironmentError(path.string(), reason_of(error));
    throw wrong("cannot be opened: " + reason_of(error));
  }
  struct stat status {};
  if (::fstat(in.number(), &status) != 0) throw EnvironmentError(path.string(), reason_of(errno));
  if (S_ISDIR(status.st_mode)) throw wrong("is a folder, not a file");
  const std::string allowed = "at most " + std::to_string(limit_bytes) + " bytes";
  if (S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) > limit_bytes) {
    throw wrong("is too large (" + std::to_string(status.st_size) + " bytes)", allowed);
  }
  std::string content;
  std::array<char, 65536> buffer{};
  while (true) {
    const std::uint64_t room = limit_bytes - content.size();
    const std::size_t wanted = room < buffer.size() ? static_cast<std::size_t>(room) + 1 : buffer.size();
    const ssize_t got = ::read(in.number(), buffer.data(), wanted < buffer.size() ? wanted : buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw EnvironmentError(path.string(), "cannot be read: " + reason_of(errno));
    if (got == 0) return content;
    content.append(buffer.data(), static_cast<std::size_t>(got));
    if (content.size() > limit_bytes) throw wrong("is too large", allowed);
  }
}

}  // namespace radcert
