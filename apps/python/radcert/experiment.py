# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems that differ in a few parts, compared at equal cost."""
import os
from typing import Any, Union

from . import _core
from .factors import Listener, Path, Store, store_name, write
from .problem import Solution


class Experiment:
    """The results of an experiment: ``names`` of the combinations, and ``solutions`` in their order (without the values at
    nodes)."""

    def __init__(self, run):
        self._run = run
        self.names = run.names
        self.solutions = [Solution(each) for each in run.solutions()]

    def to_json(self) -> dict[str, Any]:
        """What ``radcert experiment --json`` writes, as a dict."""
        return self._run.json()

    def to_csv(self, path: Path) -> None:
        """Writes the levels of all combinations, a row each."""
        write(path, self._run.csv())

    def to_latex(self, path: Path) -> None:
        """Writes the combinations as a table for LaTeX."""
        write(path, self._run.latex())


def experiment(document: Union[dict[str, Any], Path], *, store: Store = None, progress: Listener = None) -> Experiment:
    """Runs an experiment: a dict as the file format radcert/experiment/1 has it, or the name of a file."""
    if isinstance(document, (str, os.PathLike)):
        import json

        with open(document, encoding="utf-8") as file:
            return Experiment(_core.run_experiment(json.load(file), os.fspath(document), store_name(store), progress))
    return Experiment(_core.run_experiment(document, "experiment", store_name(store), progress))
