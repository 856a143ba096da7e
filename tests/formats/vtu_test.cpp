// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/vtu.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "radcert/core/contract.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

/// The words of the data array of a name.
std::vector<std::string> words(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  const std::size_t begin = text.find('>', tag) + 1;
  std::istringstream in(text.substr(begin, text.find('<', begin) - begin));
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

TEST(VtuText, HasThreePointsOfItsOwnAndOneCellAnElement) {
  const std::string text = vtu_text(test::sample_level().elements);
  EXPECT_NE(text.find("NumberOfPoints=\"6\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_EQ(words(text, "points").size(), 18U);
  EXPECT_EQ(words(text, "points")[5], "0.1");
  EXPECT_EQ(words(text, "connectivity"), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
  EXPECT_EQ(words(text, "offsets"), (std::vector<std::string>{"3", "6"}));
  EXPECT_EQ(words(text, "types"), (std::vector<std::string>{"5", "5"}));
  EXPECT_EQ(words(text, "piece"), (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(words(text, "radiosity"),
            (std::vector<std::string>{"0.3333333333333333", "2", "3", "4", "5", "-6"}));
}

TEST(VtuText, HasALegendOfPiecesThatNeedsNoStrings) {
  auto elements = test::sample_level().elements;
  elements[0].piece = "a <b> & \"c\"";
  const std::string text = vtu_text(elements);
  EXPECT_EQ(text.find("type=\"String\""), std::string::npos);
  EXPECT_EQ(words(text, "piece 0: a &lt;b&gt; &amp; &quot;c&quot;"), (std::vector<std::string>{"0"}));
  EXPECT_EQ(words(text, "piece 1: " + elements[1].piece), (std::vector<std::string>{"1"}));
}

TEST(VtuText, HasTheErrorWhereItIsKnown) {
  const auto elements = test::sample_level().elements;
  EXPECT_EQ(vtu_text(elements).find("Name=\"error\""), std::string::npos);
  const CornerErrors errors = {{0.5, 0, 1e-300}, {1, 2, 3}};
  EXPECT_EQ(words(vtu_text(elements, errors), "error"),
            (std::vector<std::string>{"0.5", "0", "1e-300", "1", "2", "3"}));
  EXPECT_THROW((void)vtu_text(elements, CornerErrors(1)), ContractViolation);
}

TEST(VtuText, RefusesNumbersThatAreNotFinite) {
  auto elements = test::sample_level().elements;
  elements[0].corner_values[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)vtu_text(elements), ContractViolation);
}

TEST(VtuText, HasWhatIsProvedOfAFunctionAndOfValues) {
  SolutionEnclosure function{.wanted = {.width = 1, .of = EnclosedQuantity::function}};
  function.function = FunctionBound{.sup = 0.25};
  for (const char* piece : {"floor", "east", "floor"})
    function.patches.push_back({.piece = piece,
                                .corners = {Vector<double>{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}},
                                .values = {1, 2, 3, 4},
                                .bound = 0.125});
  const std::string text = vtu_text(function);
  EXPECT_NE(text.find("NumberOfPoints=\"12\" NumberOfCells=\"3\""), std::string::npos);
  EXPECT_EQ(words(text, "types"), (std::vector<std::string>{"9", "9", "9"}));
  EXPECT_EQ(words(text, "offsets"), (std::vector<std::string>{"4", "8", "12"}));
  EXPECT_EQ(words(text, "piece"), (std::vector<std::string>{"0", "1", "0"}));
  EXPECT_EQ(words(text, "bound"), (std::vector<std::string>{"0.125", "0.125", "0.125"}));
  EXPECT_EQ(words(text, "radiosity").size(), 12U);
  EXPECT_EQ(words(text, "points")[11], "0.5");

  SolutionEnclosure values{.wanted = {.width = 1, .of = EnclosedQuantity::values}};
  values.points.push_back({"east", {1, Rational(1, 2), 0}, Approximation::proved(0.5, 0.001)});
  const std::string points = vtu_text(values);
  EXPECT_EQ(words(points, "types"), (std::vector<std::string>{"1"}));
  EXPECT_EQ(words(points, "points"), (std::vector<std::string>{"1", "0.5", "0"}));
  EXPECT_EQ(words(points, "radius"), (std::vector<std::string>{"0.001"}));
  values.emissions.push_back(
      {.emission = "a<b", .points = {{"east", {1, Rational(1, 2), 0}, Approximation::proved(0.25, 0.5)}}});
  const std::string further = vtu_text(values);
  EXPECT_EQ(words(further, "radiosity"), (std::vector<std::string>{"0.5"}));
  EXPECT_EQ(words(further, "radiosity, a&lt;b"), (std::vector<std::string>{"0.25"}));
  EXPECT_EQ(words(further, "radius, a&lt;b"), (std::vector<std::string>{"0.5"}));
}

}  // namespace
}  // namespace radcert
