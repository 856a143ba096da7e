// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/errors.h"

#include "radcert/core/text.h"

#include <utility>

namespace radcert {

namespace {

constexpr std::size_t path_limit = 400;

/// As it is where it prints on one line, quotation and escaped otherwise.
std::string printable(const std::string& text, std::size_t limit) {
  std::string shown = quotation(text, limit);
  return shown.size() == text.size() + 2 ? text : shown;
}

std::string message(const InputFault& fault) {
  std::string out;
  if (!fault.source.empty()) out += printable(fault.source, path_limit) + ": ";
  if (!fault.pointer.empty()) out += printable(fault.pointer, path_limit) + ": ";
  if (fault.value) out += quotation(*fault.value) + " ";
  out += printable(fault.problem, path_limit);
  if (!fault.allowed.empty()) out += "; allowed: " + printable(fault.allowed, 4 * path_limit);
  return out;
}

}  // namespace

InputError::InputError(InputFault fault)
    : std::runtime_error(message(fault)), fault_(std::make_shared<const InputFault>(std::move(fault))) {}

void refuse_input(std::string pointer, std::string value, std::string problem, std::string allowed) {
  throw InputError({.pointer = std::move(pointer),
                    .value = std::move(value),
                    .problem = std::move(problem),
                    .allowed = std::move(allowed)});
}

InputError InputError::with_source(const std::string& source) const {
  InputFault fault = *fault_;
  if (fault.source.empty()) fault.source = source;
  return InputError(std::move(fault));
}

InputError InputError::below(const std::string& pointer) const {
  InputFault fault = *fault_;
  fault.pointer = pointer + fault.pointer;
  return InputError(std::move(fault));
}

EnvironmentError::EnvironmentError(const std::string& subject, const std::string& reason)
    : std::runtime_error(printable(subject, path_limit) + ": " + printable(reason, path_limit)) {}

AccuracyNotReached::AccuracyNotReached(const std::string& subject, const std::string& reason)
    : std::runtime_error(printable(subject, path_limit) + ": " + printable(reason, path_limit)) {}

Interrupted::Interrupted() : std::runtime_error("interrupted") {}

}  // namespace radcert
