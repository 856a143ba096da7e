# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress of a computation, in a terminal or a notebook."""
import sys


def progress_bar(stream=None, width=30):
    """A function for ``progress=``: draws a line that grows, on stderr where no stream is given.

    A notebook shows it as a terminal does: the line is drawn anew after a carriage return.
    """
    out = sys.stderr if stream is None else stream
    longest = 0

    def draw(fraction, words):
        nonlocal longest
        done = int(round(width * min(max(fraction, 0), 1)))
        line = f"[{'#' * done}{'.' * (width - done)}] {100 * fraction:3.0f} % {words}"
        out.write("\r" + line.ljust(longest))
        longest = max(longest, len(line))
        if fraction >= 1:
            out.write("\n")
        out.flush()

    return draw
