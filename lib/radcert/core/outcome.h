// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/contract.h"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace radcert {

/// Why there is no value; converts to every Outcome with that reason.
/// Requires  nothing
/// Result    made by because(...)
template <class Reason>
struct Refusal {
  Reason reason;
};

/// Why there is no value: `return because("...")` from a function that gives an Outcome.
[[nodiscard]] inline Refusal<std::string> because(std::string reason) { return {std::move(reason)}; }
[[nodiscard]] inline Refusal<std::string> because(const char* reason) { return {reason}; }
template <class Reason>
  requires std::is_class_v<Reason>
[[nodiscard]] Refusal<Reason> because(Reason reason) { return {std::move(reason)}; }

/// A value, or the reason why the mathematics gives none.
/// Requires  value(), *, -> only where it has a value, reason() only where it has none, else
///           ContractViolation (which shows the reason)
/// Result    `return value;` and `return because("...");` both convert
/// Limits    for expected answers (not convergent, not decided, malformed text), not for mistakes of the
///           caller or failures of the world
template <class T, class Reason = std::string>
class [[nodiscard]] Outcome {
public:
  Outcome(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Outcome(Refusal<Reason> refusal) : content_(std::in_place_index<1>, std::move(refusal)) {}

  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  [[nodiscard]] const T& value() const& {
    require_value();
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T& value() & {
    require_value();
    return *std::get_if<0>(&content_);
  }
  [[nodiscard]] T value() && {
    require_value();
    return std::move(*std::get_if<0>(&content_));
  }
  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] T operator*() && { return std::move(*this).value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }
  [[nodiscard]] T* operator->() { return &value(); }
  [[nodiscard]] T value_or(T other) const { return has_value() ? value() : std::move(other); }

  [[nodiscard]] const Reason& reason() const {
    expects(!has_value(), "an outcome with a value has no reason");
    return std::get_if<1>(&content_)->reason;
  }

private:
  void require_value() const {
    if (!has_value()) [[unlikely]] {
      expects(false, "an outcome is asked for its value only when it has one", named("reason", reason()));
    }
  }
  std::variant<T, Refusal<Reason>> content_;
};

/// Success without a value, or the reason for failure.
/// Requires  reason() only where it has no value, else ContractViolation
/// Result    `return {};` is success
/// Limits    as Outcome<T>
template <class Reason>
class [[nodiscard]] Outcome<void, Reason> {
public:
  Outcome() = default;
  Outcome(Refusal<Reason> refusal) : content_(std::in_place_index<1>, std::move(refusal)) {}
  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  [[nodiscard]] const Reason& reason() const {
    expects(!has_value(), "an outcome that succeeded has no reason");
    return std::get_if<1>(&content_)->reason;
  }

private:
  std::variant<std::monostate, Refusal<Reason>> content_;
};

}  // namespace radcert
