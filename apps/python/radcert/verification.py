# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims held against their recorded verdicts, for somebody's own tests."""
import os
from typing import Any

from . import _core
from .factors import Listener, Path, Store, store_name


class Report:
    """What a run of claims found: ``statements``, each with name, says, verdict, recorded, as_recorded, value (value, radius,
    guaranteed), printed, note, failure, seconds."""

    def __init__(self, report):
        self._report = report
        self.statements = report.statements

    @property
    def as_recorded(self) -> bool:
        """Whether every verdict is the recorded one, neither worse nor better."""
        return self._report.as_recorded

    @property
    def differing(self) -> list[_core.Statement]:
        """The statements whose verdict is another than recorded."""
        return [each for each in self.statements if not each.as_recorded]

    def assert_as_recorded(self) -> None:
        """Raises AssertionError with the table of what differs, for pytest."""
        if not self.as_recorded:
            raise AssertionError(self.text())

    def text(self) -> str:
        """The table that ``radcert verify`` prints."""
        return self._report.text()

    def to_json(self) -> dict[str, Any]:
        """What ``radcert verify --json`` writes, as a dict."""
        return self._report.json()

    def __repr__(self):
        return f"<Report of {len(self.statements)} statements, {len(self.differing)} differ from their record>"


def claims() -> list[dict[str, Any]]:
    """The statements of the papers inside radcert: a list of dicts with name ("ac98/lemma_2_1"), says, and cells, the names of
    a table's cells. ``verify`` takes each of these names."""
    return _core.claims()


def verify(*claims: Path, budget: str = "quick", store: Store = None, progress: Listener = None) -> Report:
    """Runs claims and holds each verdict against its record.

    claims: papers inside radcert ("ac98"), one of their statements ("ac98/lemma_2_1"), folders with a claims.toml of your
        own, or one of these with /CLAIM; all papers where none is named.
    budget: "quick", "standard" or "full". store: as in ``Problem.solve``.
    """
    words = [os.fspath(each) for each in claims]
    return Report(_core.verify(words, budget, store_name(store), progress))
