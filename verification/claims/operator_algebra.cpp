// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/operator_algebra.h"

#include <utility>

#include "radcert/core/contract.h"

namespace radcert::verification {
namespace {

// Between which spaces a letter acts: functions or values at the nodes.
char source_of(char letter) { return letter == 'B' || letter == 'X' ? 'N' : 'F'; }
char target_of(char letter) { return letter == 'R' || letter == 'X' ? 'N' : 'F'; }

void add(std::map<std::string, Rational>& terms, const std::string& word, const Rational& multiple) {
  Rational& place = terms[word];
  place += multiple;
  if (place.sign() == 0) terms.erase(word);
}

// The first word that is not the identity, which tells between which spaces the sum acts.
std::optional<std::string> first_word(const Operator& a) {
  for (const auto& [word, multiple] : a.terms())
    if (!word.empty()) return word;
  return std::nullopt;
}

// The identity adds to what acts within one space.
void expect_one_pair_of_spaces(const Operator& a) {
  const std::optional<std::string> first = first_word(a);
  if (!first) return;
  for (const auto& [word, multiple] : a.terms()) {
    const bool fits = word.empty() ? source_of(first->back()) == target_of(first->front())
                                   : source_of(word.back()) == source_of(first->back()) &&
                                         target_of(word.front()) == target_of(first->front());
    expects(fits, "operators between the same spaces", named("word", word), named("first", *first));
  }
}

}  // namespace

Operator::Operator(const Rational& multiple) { add(terms_, "", multiple); }

Operator::Operator(const std::string& word) {
  expects(word.find_first_not_of("KPYZRBX") == std::string::npos, "letters of the list", named("word", word));
  for (std::size_t i = 1; i < word.size(); ++i)
    expects(source_of(word[i - 1]) == target_of(word[i]), "letters whose spaces fit", named("word", word));
  add(terms_, word, 1);
}

Operator operator+(const Operator& a, const Operator& b) {
  Operator sum = a;
  for (const auto& [word, multiple] : b.terms_) add(sum.terms_, word, multiple);
  expect_one_pair_of_spaces(sum);
  return sum;
}

Operator operator-(const Operator& a, const Operator& b) { return a + Operator(-1) * b; }

Operator operator*(const Operator& a, const Operator& b) {
  Operator product(0);
  for (const auto& [left, c] : a.terms_)
    for (const auto& [right, d] : b.terms_)
      for (const auto& [word, one] : Operator(left + right).terms_) add(product.terms_, word, c * d * one);
  expect_one_pair_of_spaces(product);
  return product;
}

OperatorRelations::OperatorRelations(std::vector<Rule> rules) : rules_(std::move(rules)) {
  for (const Rule& first : rules_)
    for (const Rule& second : rules_) {
      const std::string& a = first.product;
      const std::string& b = second.product;
      for (std::size_t shared = 1; shared < a.size() && shared < b.size(); ++shared)
        if (a.substr(a.size() - shared) == b.substr(0, shared))
          expects(differing_words(first.replacement * Operator(b.substr(shared)),
                                  Operator(a.substr(0, a.size() - shared)) * second.replacement) == 0,
                  "confluent rules", named("first", a), named("second", b));
      expects(&first == &second || a.find(b) == std::string::npos, "no left side within another",
              named("outer", a), named("inner", b));
    }
}

Operator OperatorRelations::normal_form(const Operator& a) const {
  for (const auto& [word, multiple] : a.terms())
    for (const Rule& rule : rules_) {
      const std::size_t at = word.find(rule.product);
      if (at == std::string::npos) continue;
      const Operator replaced =
          Operator(word.substr(0, at)) * rule.replacement * Operator(word.substr(at + rule.product.size()));
      return normal_form(a - Operator(multiple) * (Operator(word) - replaced));
    }
  return a;
}

Rational OperatorRelations::differing_words(const Operator& a, const Operator& b) const {
  return {static_cast<long>(normal_form(a - b).terms().size())};
}

}  // namespace radcert::verification
