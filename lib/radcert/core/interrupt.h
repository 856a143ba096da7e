// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert {

/// Makes SIGINT and SIGTERM ask for an orderly stop, and sees to it that there is one.
/// Source    POSIX sigaction(2), timer_settime(2)
/// Requires  called from the main program, not from a library
/// Result    the first signal sets the flag that interruption_requested() reads. A process that has not ended
///           seven tenths of a second later says the last words and ends with exit code 130, and a second
///           signal of its kind ends it as usual; either leaves no temporary of AtomicFile behind, and waits
///           for files that are just being renamed together
/// Limits    an orderly stop comes where a computation looks at the flag; parallel loops look between chunks.
///           What ends by the clock has lost what was not in a store yet
void install_interrupt_handler();

/// What the process says on stderr if it ends by the clock; cut at 500 bytes.
/// Requires  called from one thread at a time
void set_last_words(std::string_view words);

/// Whether the user asked to stop.
/// Requires  nothing
/// Result    exact; may be called from any thread and from a signal handler
[[nodiscard]] bool interruption_requested() noexcept;

/// Asks to stop, as the signal does; safe in a signal handler.
void request_interruption() noexcept;

/// Takes the request back, for a program that goes on after an interrupted computation.
void clear_interruption() noexcept;

/// Throws Interrupted if the user asked to stop.
void throw_if_interrupted();

}  // namespace radcert
