// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/stored_numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "radcert/core/files/result_store.h"
#include "radcert/formats/problem/problem_json.h"
#include "tests/core/temporary_folder.h"

namespace radcert {
namespace {

using test::TemporaryFolder;

std::vector<std::uint64_t> bits_of(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> out;
  for (const double x : numbers) out.push_back(std::bit_cast<std::uint64_t>(x));
  return out;
}

TEST(StoredNumbers, GiveBackTheBits) {
  const TemporaryFolder folder;
  ResultStore store(folder.path());
  const std::vector<double> numbers{0.1,
                                    -0.0,
                                    std::numeric_limits<double>::denorm_min(),
                                    -std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN(),
                                    1e300};
  StoredNumbers kept(store, "one");
  EXPECT_FALSE(kept.find("a").has_value());
  kept.keep("a", numbers);
  kept.keep("b", std::vector<double>{});
  StoredNumbers again(store, "one");
  ASSERT_TRUE(again.find("a").has_value());
  EXPECT_EQ(bits_of(*again.find("a")), bits_of(numbers));
  ASSERT_TRUE(again.find("b").has_value());
  EXPECT_TRUE(again.find("b")->empty());
  // Another work's numbers are its own.
  EXPECT_FALSE(StoredNumbers(store, "two").find("a").has_value());
  ASSERT_TRUE(store.put("one\nc", "no base64!").has_value());
  EXPECT_FALSE(kept.find("c").has_value());
}

TEST(GuaranteeKey, TellsWorksApart) {
  const auto problem = [](const std::string& width, const std::string& rho) {
    return parse_problem(R"({"schema": "radcert/problem/1", "surface": {"name": "cube"},
        "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
        "reflectivity": ")" + rho +
                             R"(", "emission": "1", "guarantee": {"width": ")" + width + R"("}})",
                         "a test");
  };
  const std::string key = guarantee_key(problem("1/10", "1/2"), false);
  EXPECT_EQ(guarantee_key(problem("0.1", "1/2"), false), key);
  EXPECT_NE(guarantee_key(problem("1/10", "1/2"), true), key);
  EXPECT_NE(guarantee_key(problem("1/11", "1/2"), false), key);
  EXPECT_NE(guarantee_key(problem("1/10", "1/3"), false), key);
}

}  // namespace
}  // namespace radcert
