// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/expression/parse.h"

#include "radcert/core/text.h"

#include <algorithm>
#include <string>
#include <tao/pegtl.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace radcert {

namespace {

namespace pegtl = tao::pegtl;

constexpr std::size_t longest_text = 4096;
constexpr int deepest_nesting = 64;

/// Leaves the parser from anywhere: PEGTL passes it through.
struct Stop {
  ExpressionFault fault;
};

[[noreturn]] void stop(std::size_t byte, std::string message) { throw Stop{{byte + 1, std::move(message)}}; }

/// The tree while it grows: `open` are the roots of the parts read so far.
struct Builder {
  ExpressionVariables variables;
  std::vector<ExpressionNode> nodes{};
  std::vector<int> open{};
  int depth = 0;

  void push(ExpressionNode node) {
    nodes.push_back(std::move(node));
    open.push_back(static_cast<int>(nodes.size()) - 1);
  }
  int pop() {
    const int place = open.back();
    open.pop_back();
    return place;
  }
  void unary(ExpressionKind kind) {
    ExpressionNode node{.kind = kind};
    node.left = pop();
    push(std::move(node));
  }
  void binary(ExpressionKind kind) {
    ExpressionNode node{.kind = kind};
    node.right = pop();
    node.left = pop();
    push(std::move(node));
  }
};

namespace grammar {

struct blank : pegtl::star<pegtl::one<' ', '\t'>> {};
template <char c>
struct token : pegtl::seq<pegtl::one<c>, blank> {};

struct sum;
struct nested_operand;

/// An operand with its signs and exponents. Every recursion of the grammar passes here, where the depth is
/// counted.
struct operand {
  using rule_t = operand;
  using subs_t = pegtl::type_list<nested_operand>;
  template <pegtl::apply_mode A, pegtl::rewind_mode M, template <class...> class Action,
            template <class...> class Control, class Input>
  static bool match(Input& in, Builder& builder) {
    if (builder.depth > deepest_nesting) {
      stop(in.position().byte, "nested more than " + std::to_string(deepest_nesting) + " deep");
    }
    ++builder.depth;
    const bool matched = pegtl::match<nested_operand, A, M, Action, Control>(in, builder);
    --builder.depth;
    return matched;
  }
};

struct fraction_digits : pegtl::plus<pegtl::digit> {};
struct exponent
    : pegtl::seq<pegtl::one<'e', 'E'>, pegtl::opt<pegtl::one<'+', '-'>>, pegtl::plus<pegtl::digit>> {};
struct number : pegtl::seq<pegtl::sor<pegtl::seq<pegtl::plus<pegtl::digit>,
                                                 pegtl::opt<pegtl::one<'.'>, pegtl::star<pegtl::digit>>>,
                                      pegtl::if_must<pegtl::one<'.'>, fraction_digits>>,
                           pegtl::opt<exponent>> {};

struct comma : token<','> {};
struct open : token<'('> {};
struct close : token<')'> {};
struct close_arguments : token<')'> {};

/// The keyword of a function, and the call, whose success puts the node into the tree.
template <ExpressionKind kind, char... letters>
struct call_of_one : pegtl::if_must<pegtl::keyword<letters...>, blank, open, sum, close> {};
template <ExpressionKind kind, char... letters>
struct call_of_two
    : pegtl::if_must<pegtl::keyword<letters...>, blank, open, sum, comma, sum, close_arguments> {};

using K = ExpressionKind;
struct call : pegtl::sor<call_of_one<K::sqrt, 's', 'q', 'r', 't'>, call_of_one<K::exp, 'e', 'x', 'p'>,
                         call_of_one<K::log, 'l', 'o', 'g'>, call_of_one<K::sin, 's', 'i', 'n'>,
                         call_of_one<K::cos, 'c', 'o', 's'>, call_of_one<K::tan, 't', 'a', 'n'>,
                         call_of_one<K::atan, 'a', 't', 'a', 'n'>, call_of_one<K::abs, 'a', 'b', 's'>,
                         call_of_two<K::min, 'm', 'i', 'n'>, call_of_two<K::max, 'm', 'a', 'x'>> {};
struct circle_number : pegtl::keyword<'p', 'i'> {};
struct variable : pegtl::identifier {};
struct group : pegtl::if_must<open, sum, close> {};
struct primary : pegtl::sor<pegtl::seq<number, blank>, call, pegtl::seq<circle_number, blank>,
                            pegtl::seq<variable, blank>, group> {};

struct raised : pegtl::if_must<token<'^'>, operand> {};
struct negated : pegtl::if_must<token<'-'>, operand> {};
struct nested_operand : pegtl::sor<negated, pegtl::seq<primary, pegtl::opt<raised>>> {};
struct times : pegtl::if_must<token<'*'>, operand> {};
struct over : pegtl::if_must<token<'/'>, operand> {};
struct product : pegtl::seq<operand, pegtl::star<pegtl::sor<times, over>>> {};
struct plus : pegtl::if_must<token<'+'>, product> {};
struct minus : pegtl::if_must<token<'-'>, product> {};
struct sum : pegtl::seq<product, pegtl::star<pegtl::sor<plus, minus>>> {};
struct whole_text : pegtl::seq<blank, pegtl::must<sum>, pegtl::must<pegtl::eof>> {};

}  // namespace grammar

std::string variable_list(ExpressionVariables variables) {
  std::string list;
  for (const std::string_view name : names(variables)) list.append(name).append(", ");
  return list;
}

/// What a rule that must match was to find.
template <class Rule>
std::string expectation(const Builder& builder) {
  if constexpr (std::is_same_v<Rule, grammar::open>) return "'(' after the name of a function";
  if constexpr (std::is_same_v<Rule, grammar::close>) return "an operator or ')'";
  if constexpr (std::is_same_v<Rule, grammar::comma>)
    return "an operator or ',': this function has two arguments";
  if constexpr (std::is_same_v<Rule, grammar::close_arguments>)
    return "an operator or ')': this function has two arguments";
  if constexpr (std::is_same_v<Rule, grammar::fraction_digits>) return "a digit";
  if constexpr (std::is_same_v<Rule, pegtl::eof>) return "an operator or the end";
  return "a number, " + variable_list(builder.variables) + "pi, a function or '('";
}

template <class Rule>
struct Control : pegtl::normal<Rule> {
  template <class Input>
  [[noreturn]] static void raise(const Input& in, const Builder& builder) {
    const std::string found = in.empty() ? "the end" : quotation(std::string_view(in.current(), 1));
    stop(in.position().byte, "expected " + expectation<Rule>(builder) + ", found " + found);
  }
};

template <class Rule>
struct Action : pegtl::nothing<Rule> {};

template <ExpressionKind kind>
struct Unary {
  static void apply0(Builder& builder) { builder.unary(kind); }
};
template <ExpressionKind kind>
struct Binary {
  static void apply0(Builder& builder) { builder.binary(kind); }
};

template <ExpressionKind kind, char... letters>
struct Action<grammar::call_of_one<kind, letters...>> : Unary<kind> {};
template <ExpressionKind kind, char... letters>
struct Action<grammar::call_of_two<kind, letters...>> : Binary<kind> {};
template <>
struct Action<grammar::negated> : Unary<ExpressionKind::negate> {};
template <>
struct Action<grammar::raised> : Binary<ExpressionKind::power> {};
template <>
struct Action<grammar::times> : Binary<ExpressionKind::multiply> {};
template <>
struct Action<grammar::over> : Binary<ExpressionKind::divide> {};
template <>
struct Action<grammar::plus> : Binary<ExpressionKind::add> {};
template <>
struct Action<grammar::minus> : Binary<ExpressionKind::subtract> {};

template <>
struct Action<grammar::circle_number> {
  static void apply0(Builder& builder) { builder.push({.kind = ExpressionKind::pi}); }
};

template <>
struct Action<grammar::number> {
  template <class Input>
  static void apply(const Input& in, Builder& builder) {
    Outcome<Rational> value = Rational::parse(in.string_view());
    if (!value) stop(in.position().byte, value.reason());
    builder.push({.kind = ExpressionKind::literal, .literal = *std::move(value)});
  }
};

template <>
struct Action<grammar::variable> {
  template <class Input>
  static void apply(const Input& in, Builder& builder) {
    const auto known = names(builder.variables);
    const auto found = std::find(known.begin(), known.end(), in.string_view());
    if (found == known.end()) {
      stop(in.position().byte, "unknown name " + quotation(in.string_view()) +
                                   "; known: " + variable_list(builder.variables) +
                                   "pi, sqrt, exp, log, sin, cos, tan, atan, abs, min, max");
    }
    builder.push({.kind = ExpressionKind::variable, .variable = static_cast<int>(found - known.begin())});
  }
};

void check_characters(std::string_view text) {
  if (text.size() > longest_text)
    stop(longest_text, "longer than " + std::to_string(longest_text) + " characters");
  for (std::size_t byte = 0; byte < text.size(); ++byte) {
    const auto letter = static_cast<unsigned char>(text[byte]);
    if (text.substr(byte, 2) == "**") stop(byte, "a power is written with ^: x^2");
    if (letter >= 0x7F || (letter < 0x20 && letter != '\t')) {
      stop(byte, "a character that no expression has: " + quotation(text.substr(byte, 1)));
    }
  }
}

}  // namespace

std::string ExpressionFault::to_text() const { return "column " + std::to_string(column) + ": " + message; }

Outcome<Expression, ExpressionFault> parse_expression(std::string_view text, ExpressionVariables variables) {
  try {
    check_characters(text);
    Builder builder{.variables = variables};
    pegtl::memory_input in(text.data(), text.size(), "");
    pegtl::parse<grammar::whole_text, Action, Control>(in, builder);
    return Expression(std::move(builder.nodes), std::string(text), variables);
  } catch (Stop& stopped) {
    return because(std::move(stopped.fault));
  }
}

}  // namespace radcert
