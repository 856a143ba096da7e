// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace radcert {

/// The exit codes of the program.
/// Source    apps/radcert/README.md
/// Requires  nothing
/// Result    done: every verdict as recorded; differs: a verdict differs, or a demanded accuracy was not
///           reached; input: the user's input is wrong; environment: disk, package, memory; interrupted: what
///           was finished is kept
enum class ExitCode : int { done = 0, differs = 1, input = 2, environment = 3, interrupted = 130 };

/// The parts of a message about wrong input.
/// Source    RFC 6901 for `pointer`
/// Requires  raw text in every field: quoting is done by InputError
/// Result    source: a file, or what else the input came from; pointer: the place in it; value: what stands
///           there, if anything does; problem: what is wrong with it; allowed: what would have been right
/// Limits    an empty field is left out of the message
struct InputFault {
  std::string source{};
  std::string pointer{};
  std::optional<std::string> value{};
  std::string problem = "is not allowed";
  std::string allowed{};
};

/// The user's input is wrong.
/// Requires  nothing
/// Result    what() is one printable line, `problem.json: /basis/alpha: "1/3" is not allowed; allowed: a
///           number in [0, 1/3)`; copying does not throw
/// Limits    one fault an error
class InputError : public std::runtime_error {
public:
  explicit InputError(InputFault fault);
  [[nodiscard]] const InputFault& fault() const { return *fault_; }
  /// The same error, its source filled in where it was empty.
  [[nodiscard]] InputError with_source(const std::string& source) const;
  /// The same error, seen from the object above: "/basis" before "/alpha" makes "/basis/alpha".
  [[nodiscard]] InputError below(const std::string& pointer) const;

private:
  std::shared_ptr<const InputFault> fault_;
};

/// Throws the InputError of a value at a place, its source to be filled in by the reader of the file.
[[noreturn]] void refuse_input(std::string pointer, std::string value, std::string problem,
                               std::string allowed);

/// Runs an action; an InputError that leaves it names the source.
/// Requires  nothing
/// Result    the action's own result; an InputError without a source leaves with this one, every other
///           exception as it is
template <class Action>
decltype(auto) with_source(const std::string& source, Action&& action) {
  try {
    return static_cast<Action&&>(action)();
  } catch (const InputError& error) {
    throw error.with_source(source);
  }
}

/// The world failed: a disk, a package, memory.
/// Requires  a subject (path, package) and a reason in words
/// Result    what() is `<subject>: <reason>` on one printable line
class EnvironmentError : public std::runtime_error {
public:
  EnvironmentError(const std::string& subject, const std::string& reason);
};

/// An accuracy that the user demanded was not reached.
/// Requires  a subject (what was computed) and a reason in words with the accuracy reached
/// Result    what() is `<subject>: <reason>` on one printable line; the program ends with ExitCode::differs
/// Limits    for demands: what a computation reaches without one is a radius in its result
class AccuracyNotReached : public std::runtime_error {
public:
  AccuracyNotReached(const std::string& subject, const std::string& reason);
};

/// The user asked to stop.
/// Requires  nothing
/// Result    thrown by throw_if_interrupted() and by parallel loops; what was finished before is kept
class Interrupted : public std::runtime_error {
public:
  Interrupted();
};

}  // namespace radcert
