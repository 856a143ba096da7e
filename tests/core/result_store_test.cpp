// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/files/result_store.h"

#include "radcert/core/files/atomic_file.h"
#include "radcert/core/parallel.h"
#include "tests/core/temporary_folder.h"

#include <atomic>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

namespace {

using radcert::read_file, radcert::ResultStore, radcert::write_atomically;
using radcert::test::TemporaryFolder;

TEST(ResultStore, GivesBackWhatWasPut) {
  const TemporaryFolder folder;
  ResultStore store(folder / "made/when/needed");
  EXPECT_FALSE(store.get("key").has_value());
  const std::string binary("\0\n\xff radcert result 1\n", 20);
  for (const std::string& key :
       {std::string(), std::string("key"), std::string("a\nb\0c", 5), std::string(100000, 'k')}) {
    ASSERT_TRUE(store.put(key, binary).has_value());
    EXPECT_EQ(store.get(key), binary);
    ASSERT_TRUE(store.put(key, "").has_value());
    EXPECT_EQ(store.get(key), "");
  }
  EXPECT_EQ(ResultStore(folder / "made/when/needed").get("key"), "");
}

TEST(ResultStore, CanIgnoreWhatWasPutEarlier) {
  const TemporaryFolder folder;
  ASSERT_TRUE(ResultStore(folder.path()).put("one", "earlier").has_value());
  ResultStore store(folder.path());
  store.ignore_earlier();
  EXPECT_FALSE(store.get("one").has_value());
  ASSERT_TRUE(store.put("one", "now").has_value());
  store.ignore_earlier();
  EXPECT_EQ(store.get("one"), "now");
  EXPECT_EQ(ResultStore(folder.path()).get("one"), "now");
}

TEST(ResultStore, ReadsAFileOfAnotherKeyAsAbsent) {
  const TemporaryFolder folder;
  ResultStore store(folder.path());
  ASSERT_TRUE(store.put("one", "result of one").has_value());
  std::filesystem::copy_file(store.file("one"), store.file("two"));
  EXPECT_FALSE(store.get("two").has_value());
  // The boundary of key and content is part of what is checked.
  std::filesystem::copy_file(store.file("one"), store.file("oner"));
  EXPECT_FALSE(store.get("oner").has_value());
}

TEST(ResultStore, ReadsARecordOfAnotherLayoutAsAbsent) {
  const TemporaryFolder folder;
  ResultStore store(folder.path());
  ASSERT_TRUE(store.put("key", "content").has_value());
  const std::string whole = read_file(store.file("key"));
  // As earlier versions wrote it: another title, a shorter hash.
  const std::string title = whole.substr(0, whole.find('\n') + 1);
  for (const std::string& record : {"radcert result 1\n" + whole.substr(title.size()),
                                    "radcert result 1\n3 7 " + std::string(32, '0') + "\nkeycontent",
                                    title + "3 7 " + std::string(32, '0') + "\nkeycontent",
                                    title + "3 7 " + std::string(64, '0') + "\nkeycontent"}) {
    write_atomically(store.file("key"), record);
    EXPECT_FALSE(store.get("key").has_value()) << record;
  }
}

TEST(ResultStore, ReadsADamagedFileAsAbsent) {
  const TemporaryFolder folder;
  ResultStore store(folder.path());
  ASSERT_TRUE(store.put("key", "some content").has_value());
  const std::string whole = read_file(store.file("key"));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write_atomically(store.file("key"), std::string_view(whole).substr(0, length));
    EXPECT_FALSE(store.get("key").has_value()) << "cut to " << length;
  }
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string altered = whole;
    altered[place] = static_cast<char>(altered[place] ^ 1);
    write_atomically(store.file("key"), altered);
    EXPECT_FALSE(store.get("key").has_value()) << "altered at " << place;
  }
  write_atomically(store.file("key"), whole + "x");
  EXPECT_FALSE(store.get("key").has_value());
  write_atomically(store.file("key"), whole);
  EXPECT_EQ(store.get("key"), "some content");
}

TEST(ResultStore, SwitchesItselfOffWhereItCannotWrite) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "in the way");
  ResultStore store(folder / "file/store");
  EXPECT_TRUE(store.status().has_value());
  EXPECT_FALSE(store.get("key").has_value());
  EXPECT_FALSE(store.put("key", "content").has_value());
  ASSERT_FALSE(store.status().has_value());
  EXPECT_NE(store.status().reason().find("file/store"), std::string::npos) << store.status().reason();
  EXPECT_FALSE(store.get("key").has_value());
  EXPECT_FALSE(store.put("key", "content").has_value());
}

TEST(ResultStore, SwitchedOffKeepsNothing) {
  ResultStore store = ResultStore::none("not wanted");
  EXPECT_EQ(store.put("key", "content").reason(), "not wanted");
  EXPECT_FALSE(store.get("key").has_value());
}

TEST(ResultStore, IsSharedByThreads) {
  const TemporaryFolder folder;
  ResultStore store(folder.path());
  std::atomic<int> wrong{0};
  radcert::parallel_for(200, 1, [&](std::size_t i, std::size_t) {
    const std::string key = std::to_string(i % 5);
    const std::string content(1000, static_cast<char>('a' + i % 5));
    if (!store.put(key, content).has_value() || store.get(key) != content) ++wrong;
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(folder.entries(), 5U);
}

class Environment {
public:
  explicit Environment(const char* name)
      : name_(name), was_set_(std::getenv(name) != nullptr), old_(was_set_ ? std::getenv(name) : "") {}
  ~Environment() {
    if (was_set_) {
      setenv(name_, old_.c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  bool was_set_;
  std::string old_;
};

TEST(ResultStore, FindsItsFolderInTheEnvironment) {
  const Environment store("RADCERT_STORE");
  const Environment cache("XDG_CACHE_HOME");
  const Environment home("HOME");
  setenv("RADCERT_STORE", "/one", 1);
  setenv("XDG_CACHE_HOME", "/two", 1);
  setenv("HOME", "/three", 1);
  EXPECT_EQ(ResultStore().folder(), "/one");
  setenv("RADCERT_STORE", "", 1);
  EXPECT_EQ(ResultStore().folder(), "/two/radcert");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(ResultStore().folder(), "/three/.cache/radcert");
  unsetenv("HOME");
  EXPECT_FALSE(ResultStore().status().has_value());
}

}  // namespace
