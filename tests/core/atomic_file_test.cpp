// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/files/atomic_file.h"

#include "radcert/core/errors.h"
#include "tests/core/temporary_folder.h"

#include <csignal>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using radcert::EnvironmentError, radcert::InputError, radcert::read_file, radcert::write_atomically;
using radcert::test::TemporaryFolder;

template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no such exception";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(WriteAtomically, WritesWhatReadFileReads) {
  const TemporaryFolder folder;
  for (const std::string& content :
       {std::string(), std::string("text\n"), std::string("\0\xff\r\n", 4), std::string(300000, 'x')}) {
    write_atomically(folder / "file", content);
    EXPECT_EQ(read_file(folder / "file"), content);
  }
  EXPECT_EQ(folder.entries(), 1U);
}

/// No file may grow beyond a limit while this lives: the writes then fail as on a full disk.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  void (*old_handler_)(int);
  rlimit old_{};
};

TEST(WriteAtomically, LeavesTheOldFileAndNoTemporaryWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message =
        message_of<EnvironmentError>([&] { write_atomically(folder / "file", std::string(5000, 'n')); });
  }
  EXPECT_TRUE(contains(message, (folder / "file").string())) << message;
  EXPECT_TRUE(contains(message, "too large")) << message;
  EXPECT_EQ(read_file(folder / "file"), "old");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(WriteTogether, WritesAllFilesOrNone) {
  const TemporaryFolder folder;
  radcert::write_together({{folder / "a", "old a"}, {folder / "b", "old b"}});
  {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(radcert::write_together({{folder / "a", "new"}, {folder / "b", std::string(5000, 'n')}}),
                 EnvironmentError);
    EXPECT_THROW(radcert::write_together({{folder / "a", "new"}, {folder / "none/b", "new"}}),
                 EnvironmentError);
  }
  EXPECT_EQ(read_file(folder / "a"), "old a");
  EXPECT_EQ(read_file(folder / "b"), "old b");
  EXPECT_EQ(folder.entries(), 2U);
  radcert::AtomicFile more(folder / "more");
  more.put("piece ");
  more.put("by piece");
  radcert::write_together({{folder / "a", "new a"}}, &more);
  EXPECT_EQ(read_file(folder / "a"), "new a");
  EXPECT_EQ(read_file(folder / "more"), "piece by piece");
  EXPECT_EQ(folder.entries(), 3U);
}

TEST(WriteAtomically, NamesPathAndReason) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(message_of<EnvironmentError>([&] { write_atomically(folder / "none/file", "x"); }),
                       "none/file: cannot be written: No such file"));
  EXPECT_TRUE(contains(message_of<EnvironmentError>([&] { write_atomically(folder.path(), "x"); }),
                       "it is a folder"));
  EXPECT_THROW(write_atomically("", "x"), InputError);
  EXPECT_THROW(write_atomically(folder / std::string("a\0b", 3), "x"), InputError);
  EXPECT_EQ(folder.entries(), 0U);
}

// A pipe stands for every device: a test must not endanger those of the machine.
TEST(WriteAtomically, WritesIntoAPipeInsteadOfReplacingIt) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  write_atomically(folder / "pipe", "text");
  char received[8] = {};
  EXPECT_EQ(read(reader, received, sizeof received), 4);
  EXPECT_STREQ(received, "text");
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
}

TEST(WriteAtomically, KeepsRightsAndFollowsLinks) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "old");
  ASSERT_EQ(chmod((folder / "file").c_str(), 0640), 0);
  std::filesystem::create_symlink("file", folder / "link");
  write_atomically(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_file(folder / "file"), "new");
  struct stat status {};
  ASSERT_EQ(stat((folder / "file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(ReadFile, RefusesWhatIsNotAFileOfAdmittedLength) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "12345");
  EXPECT_EQ(read_file(folder / "file", 5), "12345");
  EXPECT_TRUE(contains(message_of<InputError>([&] { (void)read_file(folder / "file", 4); }),
                       "file: is too large (5 bytes); allowed: at most 4 bytes"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { (void)read_file(folder / "none"); }),
                       "none: cannot be opened: No such file"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { (void)read_file(folder.path()); }), "is a folder"));
  EXPECT_TRUE(contains(message_of<InputError>([&] { (void)read_file(folder / std::string("file\0", 5)); }),
                       "is not a file name"));
}

TEST(ReadFile, HoldsTheLimitWhereTheSizeIsNotKnownInAdvance) {
  EXPECT_GT(read_file("/proc/self/maps").size(), 100U);
  EXPECT_THROW((void)read_file("/proc/self/maps", 100), InputError);
}

}  // namespace
