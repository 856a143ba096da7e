// SPDX-License-Identifier: GPL-3.0-or-later

// Every reader on inputs that chance has made of valid ones: it returns or says what is wrong with them.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "tests/fuzz/readers.h"

namespace radcert::fuzz {
namespace {

/// Makes inputs of others: bytes and pieces changed, left out, doubled, taken from another input, and words
/// of a dictionary put in.
class Mutator {
public:
  Mutator(std::vector<std::string> seeds, std::vector<std::string> words, std::uint64_t seed)
      : seeds_(std::move(seeds)), words_(std::move(words)), chance_(seed) {}

  std::string next() {
    std::string text = seeds_[below(seeds_.size())];
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(text);
    return text;
  }

private:
  std::size_t below(std::size_t count) { return count == 0 ? 0 : chance_() % count; }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = below(std::min<std::size_t>(text.size() - at, 40) + 1);
    const std::string piece = text.substr(at, length);
    switch (below(9)) {
      case 0: text.insert(at, 1, static_cast<char>(chance_())); break;
      case 1:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2: text.erase(at, length); break;
      case 3: text.insert(below(text.size() + 1), piece); break;
      case 4: text.resize(at); break;
      case 5: text.replace(at, length, number()); break;
      case 6: {
        const std::string& other = seeds_[below(seeds_.size())];
        const std::size_t from = below(other.size() + 1);
        text.insert(at, other, from, below(60));
        break;
      }
      case 7:
        for (std::size_t times = below(200); times > 0; --times) text.insert(at, piece);
        break;
      default:
        if (!words_.empty()) text.insert(at, words_[below(words_.size())]);
    }
  }

  std::string number() {
    static const std::vector<std::string> numbers = {"0",
                                                     "-0",
                                                     "1",
                                                     "-1",
                                                     "2",
                                                     "3",
                                                     "7",
                                                     "1e400",
                                                     "1e-400",
                                                     "-9223372036854775808",
                                                     "9223372036854775807",
                                                     "18446744073709551616",
                                                     "4294967296",
                                                     "2147483648",
                                                     "0.1",
                                                     "1/3",
                                                     "1/0",
                                                     "1e308",
                                                     "5e-324",
                                                     "nan",
                                                     "inf",
                                                     "1e60",
                                                     "1e61"};
    return numbers[below(numbers.size())];
  }

  std::vector<std::string> seeds_;
  std::vector<std::string> words_;
  std::mt19937_64 chance_;
};

class Readers : public testing::TestWithParam<std::string> {};

TEST_P(Readers, TakeTheirSeeds) {
  const Reader& reader = *find_reader(GetParam());
  const std::vector<std::string> seeds = seeds_of(reader);
  ASSERT_FALSE(seeds.empty());
  for (const std::string& seed : seeds) EXPECT_NO_THROW(reader.read(seed));
}

TEST_P(Readers, ReturnOrSayWhatIsWrong) {
  const Reader& reader = *find_reader(GetParam());
  const char* wanted = std::getenv("RADCERT_FUZZ_INPUTS");
  const int count = wanted == nullptr ? 4000 : std::atoi(wanted);
  Mutator mutator(seeds_of(reader), words_of(reader), 1);
  for (int i = 0; i < count; ++i) {
    const std::string input = mutator.next();
    EXPECT_NO_THROW(read_any(reader, input)) << "input " << i << ": " << quotation(input, 2000);
  }
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const Reader& reader : readers()) out.push_back(reader.name);
  return out;
}

INSTANTIATE_TEST_SUITE_P(All, Readers, testing::ValuesIn(names()),
                         [](const auto& reader) { return reader.param; });

}  // namespace
}  // namespace radcert::fuzz
