// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/text.h"

#include <concepts>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace radcert {

/// The caller broke a stated requirement of a function.
/// Requires  thrown by expects() alone
/// Result    what() is `required: <requirement>; <name> = <value>, ...` on one line
/// Limits    a mistake in the calling code: not for a user's input (InputError) nor for a mathematical no
///           (Outcome)
class ContractViolation : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

/// A value with the name under which a failed requirement shows it.
/// Requires  name and value outlive the object: use it only as an argument of expects()
/// Result    nothing is turned into text before the requirement has failed
/// Limits    see description() for what can be shown
template <class T>
struct Named {
  std::string_view name;
  const T& value;
};

/// A value under a name, for expects(): see Named.
template <class T>
[[nodiscard]] constexpr Named<T> named(std::string_view name, const T& value) {
  return {name, value};
}

namespace detail {

template <class T>
concept TextByMember = requires(const T& value) {
  { value.to_text() } -> std::convertible_to<std::string>;
};

template <class T>
concept TextByFunction = requires(const T& value) {
  { to_text(value) } -> std::convertible_to<std::string>;
};

}  // namespace detail

/// A value as text for a message.
/// Requires  nothing
/// Result    text quoted and escaped; a double in its shortest exact form; else member to_text(),
///           to_text(value), the number of an enumerator
/// Limits    a type with none of these shows as `(a value without text)`
template <class T>
[[nodiscard]] std::string description(const T& value) {
  if constexpr (std::convertible_to<const T&, std::string_view>) {
    return quotation(std::string_view(value));
  } else if constexpr (std::same_as<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::floating_point<T>) {
    return shortest(static_cast<double>(value));
  } else if constexpr (std::same_as<T, char>) {
    return quotation(std::string_view(&value, 1));
  } else if constexpr (std::integral<T>) {
    return std::to_string(value);
  } else if constexpr (detail::TextByMember<T>) {
    return value.to_text();
  } else if constexpr (detail::TextByFunction<T>) {
    return to_text(value);
  } else if constexpr (std::is_enum_v<T>) {
    return std::to_string(static_cast<std::underlying_type_t<T>>(value));
  } else {
    return "(a value without text)";
  }
}

namespace detail {

struct ShownValue {
  std::string_view name;
  std::string text;
};

[[noreturn]] void violated(std::string_view requirement, std::initializer_list<ShownValue> values);

}  // namespace detail

/// Checks a requirement of the calling code, in every build.
/// Requires  nothing
/// Result    returns when the condition holds, else throws ContractViolation with the requirement and the
///           named values
/// Limits    the values are evaluated by the caller either way; their text is made only on failure
template <class... T>
constexpr void expects(bool condition, std::string_view requirement, const Named<T>&... values) {
  if (!condition) [[unlikely]] {
    detail::violated(requirement, {detail::ShownValue{values.name, description(values.value)}...});
  }
}

}  // namespace radcert
