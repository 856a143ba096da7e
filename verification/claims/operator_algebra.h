// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "radcert/scalar/rational.h"

namespace radcert::verification {

/// A linear combination of products of linear operators that are letters: nothing is known of them here but
/// between which spaces they act.
/// Maths     sum of c_w w over words w, the empty word being the identity. F is a space of functions, N that
///           of their values at the nodes. K, P, Y, Z: F to F, R: F to N, B: N to F, X: N to N
/// Source    ours
/// Requires  letters of that list; products and sums of operators whose spaces fit, else ContractViolation
/// Result    exact; no product of letters is reduced: OperatorRelations does that
class Operator {
public:
  /// A multiple of the identity, of whichever space is asked for.
  Operator(const Rational& multiple);
  Operator(int multiple) : Operator(Rational(multiple)) {}
  /// A product of letters, the one that acts last in front.
  explicit Operator(const std::string& word);

  [[nodiscard]] const std::map<std::string, Rational>& terms() const { return terms_; }

  friend Operator operator+(const Operator& a, const Operator& b);
  friend Operator operator-(const Operator& a, const Operator& b);
  friend Operator operator*(const Operator& a, const Operator& b);

private:
  std::map<std::string, Rational> terms_;  // none is zero
};

/// Relations between the letters, as rules that replace a product by a combination of other operators.
/// Maths     an operator is zero by the relations if its normal form is: each replacement is an equality. If
///           the rules are confluent the converse holds as well: what has a normal form other than zero is
///           not zero for the operators on the words themselves, a linear space on which the relations hold.
///           Confluent means that a word to which two rules apply comes to one normal form by either, and it
///           is enough to look at the words in which two left sides overlap (Bergman's diamond lemma)
/// Source    G. M. Bergman, The diamond lemma for ring theory, Advances in Mathematics 29 (1978) 178-218
/// Requires  rules that end, as they do where each makes its words shorter or is otherwise seen to; confluent
///           rules, which is tried on all overlaps, else ContractViolation
/// Result    exact
class OperatorRelations {
public:
  struct Rule {
    std::string product;
    Operator replacement;
  };

  explicit OperatorRelations(std::vector<Rule> rules);

  [[nodiscard]] Operator normal_form(const Operator& a) const;
  /// How many words the normal form of a - b has: 0 if and only if a = b follows from the relations.
  [[nodiscard]] Rational differing_words(const Operator& a, const Operator& b) const;

private:
  std::vector<Rule> rules_;
};

}  // namespace radcert::verification
