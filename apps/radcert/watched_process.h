// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace radcert::app {

/// Goes on in a child of this process, which waits for it: what a process that is killed can no longer say,
/// the one that watches says.
/// Source    POSIX fork(2), waitpid(2); Linux prctl(2), PR_SET_PDEATHSIG
/// Requires  one thread; `name` is what the process is called in that message
/// Result    returns in the child alone, or here where there can be none. The watching process passes on what
///           asks to stop, and ends with the child's exit code, or with 3 where a signal has ended it
/// Limits    who kills the watching process kills the child with it, and nothing is said
void go_on_watched(const std::string& name);

}  // namespace radcert::app
