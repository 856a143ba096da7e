// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/digest.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace {

using radcert::digest_of, radcert::is_digest, radcert::length_prefixed, radcert::sha256;

// The examples that NIST publishes for SHA-256, and those of FIPS 180-2, appendix B.
TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                   "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu"),
            "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, SeesEveryByteAndTheLength) {
  std::set<std::string> seen;
  for (std::size_t length = 0; length < 130; ++length) seen.insert(sha256(std::string(length, '\0')));
  for (int byte = 1; byte < 256; ++byte) seen.insert(sha256(std::string(1, static_cast<char>(byte))));
  EXPECT_EQ(seen.size(), 130U + 255U);
}

TEST(Digest, SaysWhichFunctionItIs) {
  const std::string digest = digest_of("abc");
  EXPECT_EQ(digest, "sha256-ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_TRUE(is_digest(digest));
  for (const std::string& other :
       {std::string(), std::string("fnv1a-af63dc4c8601ec8c-1"), digest.substr(0, digest.size() - 1),
        digest + "0", digest.substr(7), "sha256-" + std::string(64, 'A'), "sha256-" + std::string(64, ' ')})
    EXPECT_FALSE(is_digest(other)) << other;
}

// Texts with one value of the 64-bit hash of Fowler, Noll and Vo, as mesh files have had.
TEST(Digest, TellsTextsApartThatA64BitHashDoesNot) {
  const std::string common =
      "\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 "
      "4\n3 "
      "3 4 7\n# ";
  const auto box = [&](const std::string& height, const std::string& end) {
    return "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 " + height + "\n1 0 " + height + "\n1 1 " + height +
           "\n0 1 " + height + common + end + "\n";
  };
  const std::string low = box("1", "ujzde8gxd6ncf10epf91dhod");
  const std::string high = box("9", std::string("\0\2\2\0\2\0\0\7\16\3\2\0\3\6\3\6\0\1\2\0\6\0\6\4", 24));
  const auto fnv1a = [](const std::string& text) {
    unsigned long hash = 0xcbf29ce484222325UL;
    for (const char byte : text) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3UL;
    return hash;
  };
  ASSERT_EQ(fnv1a(low), fnv1a(high));
  ASSERT_EQ(low.size(), high.size());
  EXPECT_NE(digest_of(low), digest_of(high));
  // What follows both alike keeps the value of the hash.
  for (const std::string tail : {"x", "\n", "a longer end\n"}) {
    ASSERT_EQ(fnv1a(low + tail), fnv1a(high + tail));
    EXPECT_NE(digest_of(low + tail), digest_of(high + tail));
  }
}

TEST(LengthPrefixed, TellsListsApartWhateverTheirWordsHold) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(length_prefixed(Words{"a", "b, c"}), "1:a4:b, c");
  const std::vector<Words> lists{{},         {""},         {"", ""},       {"a, b"},      {"a", "b"},
                                 {"b", "a"}, {"a1:b"},     {"1:a", "1:b"}, {"1:a1:b"},    {"a", "1:b"},
                                 {"ab"},     {"a\n", "b"}, {"a", "\nb"},   {"0:", "a1:"}, {"", "0:a1:"}};
  std::set<std::string> seen;
  for (const Words& words : lists) seen.insert(length_prefixed(words));
  EXPECT_EQ(seen.size(), lists.size());
}

TEST(Digest, OfFilesSeesEveryPathEveryByteAndTheOrder) {
  using Files = std::vector<radcert::EmbeddedFile>;
  const std::vector<Files> folders{{},
                                   {{"a", "1"}},
                                   {{"a", "2"}},
                                   {{"b", "1"}},
                                   {{"a", "1"}, {"b", "2"}},
                                   {{"b", "2"}, {"a", "1"}},
                                   {{"a", "2"}, {"b", "1"}},
                                   {{"a", "1\nb 2"}}};
  std::set<std::string> seen;
  for (const Files& files : folders) {
    const std::string digest = digest_of(files);
    EXPECT_TRUE(is_digest(digest));
    EXPECT_EQ(digest, digest_of(files));
    seen.insert(digest);
  }
  EXPECT_EQ(seen.size(), folders.size());
}

}  // namespace
