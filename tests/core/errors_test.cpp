// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/errors.h"

#include <gtest/gtest.h>
#include <string>
#include <type_traits>

namespace {

using radcert::AccuracyNotReached, radcert::EnvironmentError, radcert::InputError, radcert::InputFault;

TEST(InputError, IsOneReadableLine) {
  const InputError error({.source = "problem.json",
                          .pointer = "/basis/alpha",
                          .value = "1/3",
                          .allowed = "a number in [0, 1/3)"});
  EXPECT_STREQ(error.what(),
               "problem.json: /basis/alpha: \"1/3\" is not allowed; allowed: a number in [0, 1/3)");
  EXPECT_STREQ(InputError({.pointer = "/basis", .problem = "is missing"}).what(), "/basis: is missing");
}

TEST(InputError, NeverPrintsControlCharacters) {
  const InputError error(
      {.source = "a\nb", .pointer = "/\x1b[2J", .value = "\x07\xff", .problem = "bad\r", .allowed = "x\ny"});
  for (const char* letter = error.what(); *letter != 0; ++letter) EXPECT_GE(*letter, 0x20) << error.what();
}

TEST(InputError, KeepsTheRawPartsAndTakesTheFileLater) {
  const InputError inner({.pointer = "/alpha", .value = "a\nb"});
  const InputError outer = inner.below("/basis").with_source("problem.json");
  EXPECT_EQ(outer.fault().source, "problem.json");
  EXPECT_EQ(outer.fault().pointer, "/basis/alpha");
  EXPECT_EQ(outer.fault().value, "a\nb");
  EXPECT_STREQ(outer.what(), "problem.json: /basis/alpha: \"a\\nb\" is not allowed");
  EXPECT_EQ(outer.with_source("other.json").fault().source, "problem.json");
  static_assert(std::is_nothrow_copy_constructible_v<InputError>);
}

TEST(WithSource, NamesTheSourceOfErrorsThatPass) {
  EXPECT_EQ(radcert::with_source("f.json", [] { return 3; }), 3);
  try {
    radcert::with_source("f.json", []() -> void { throw InputError({.pointer = "/a"}); });
    FAIL() << "no exception";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f.json: /a: is not allowed");
  }
}

TEST(EnvironmentError, NamesSubjectAndReason) {
  EXPECT_STREQ(EnvironmentError("/out/a.csv", "disk full").what(), "/out/a.csv: disk full");
}

TEST(AccuracyNotReached, NamesSubjectAndReasonOnOneLine) {
  EXPECT_STREQ(AccuracyNotReached("level 2", "1e-3\nreached").what(), "level 2: \"1e-3\\nreached\"");
}

}  // namespace
