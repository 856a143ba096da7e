// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace radcert {

/// Makes SIGINT and SIGTERM ask for an orderly stop.
/// Source    POSIX sigaction(2)
/// Requires  called from the main program, not from a library
/// Result    the first signal sets the flag that interruption_requested() reads; a second one of its kind
///           ends the process as usual
/// Limits    a computation stops only where it looks at the flag; parallel loops look between chunks
void install_interrupt_handler();

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
