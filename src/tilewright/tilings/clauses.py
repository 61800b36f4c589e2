"""Rules as formulas: cells are variables, rules are clauses, and a SAT solver decides.

A solver's "yes" is checked here against every clause, so that it need not be believed.
"""

import time
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_real, check_type
from tilewright.errors import Progress, TilewrightError, TilewrightValueError
from tilewright.extras import need_package

Literals = NDArray[np.int32]
Truth = NDArray[np.bool_]

_CONFLICTS = 20_000
"""What the solver works through between two looks at the clock."""
_FEW = 6
"""Up to this number of variables, that at most one is true is written pair by pair."""


class Undecided(TilewrightError, TimeoutError):
    """The solver was stopped by the clock before it found a solution or proved that there is none."""


class Clauses:
    """A formula in conjunctive normal form.

    Variables are numbered from 1 on; a literal is a variable or its negative. A clause holds where at least
    one of its literals does, the formula where every clause does.
    """

    def __init__(self) -> None:
        self.count = 0
        """Variables so far."""
        self.blocks: list[Literals] = []
        """Clauses of one length each, shape (clauses, length)."""

    def __len__(self) -> int:
        return sum(len(block) for block in self.blocks)

    def variables(self, *shape: int) -> Literals:
        """New variables, as an array of the given shape."""
        first = self.count + 1
        self.count += int(np.prod(shape))
        return np.arange(first, self.count + 1, dtype=np.int32).reshape(shape)

    def add(self, literals: ArrayLike) -> None:
        """Take in clauses: their literals along the last axis."""
        block = np.atleast_2d(np.asarray(literals, np.int32))
        block = block.reshape(-1, block.shape[-1])
        if len(block):
            self.blocks.append(block)

    def at_most_one(self, variables: Literals) -> None:
        """Of the variables along the last axis, one or none is true."""
        rows = variables.reshape(-1, variables.shape[-1])
        if rows.shape[1] <= _FEW:
            for a in range(rows.shape[1]):
                for b in range(a):
                    self.add(-rows[:, [a, b]])
            return
        # A new variable stands for the second half and takes its place beside the first.
        half = rows.shape[1] // 2
        chosen = self.variables(len(rows), 1)
        self.at_most_one(np.concatenate([rows[:, :half], chosen], axis=1))
        self.at_most_one(np.concatenate([rows[:, half:], -chosen], axis=1))

    def exactly_one(self, variables: Literals) -> None:
        """Of the variables along the last axis, one is true."""
        self.add(variables)
        self.at_most_one(variables)

    def solve(
        self,
        *,
        prefer: ArrayLike = (),
        seconds: float | None = None,
        seed: int = 0,
        progress: Progress | None = None,
    ) -> Truth | None:
        """Values that make every clause true, or None where it is proven that there are none.

        Parameters
        ----------
        prefer : array-like of int
            Literals that the solver tries to make true first, so that the solution follows them.
        seconds : float, optional
            After about so long, give up.
        seed : int
            Which values the solver tries first; different seeds find different solutions.
        progress : callable, optional
            Called between stretches of the search.

        Returns
        -------
        bool array, shape (variables + 1,); entry v is the value of variable v, entry 0 is not used. None
        where the formula has no solution.

        Raises
        ------
        Undecided
            The time was up.
        MissingExtra
            The package python-sat is missing.
        """
        if seconds is not None:
            check_real("seconds", seconds, 0, 1e9)
        phases = np.arange(self.count + 1) * np.random.default_rng(seed).choice([-1, 1], self.count + 1)
        preferred = np.asarray(prefer, np.int64).ravel()
        phases[np.abs(preferred)] = preferred
        start = time.monotonic()
        with _solver(self.blocks) as solver:
            if self.count:
                solver.set_phases(phases[1:].tolist())
            found = None
            while found is None:
                solver.conf_budget(_CONFLICTS)
                found = solver.solve_limited()
                spent = time.monotonic() - start
                if progress is not None:
                    progress(int(spent), int(seconds or 0), "searching")
                if found is None and seconds is not None and spent > seconds:
                    raise Undecided(
                        f"no answer after {spent:.0f} seconds", advice="allow more or ask for less"
                    )
            if not found:
                return None
            values = np.zeros(self.count + 1, bool)
            model = np.array(solver.get_model(), np.int64)
            model = model[np.abs(model) <= self.count]
            values[np.abs(model)] = model > 0
        fault = self.violated(values)
        if fault is not None:
            raise RuntimeError(f"the solver's values make clause {fault} false")
        return values

    def conflict(self, assumed: ArrayLike) -> list[int] | None:
        """Literals among ``assumed`` that cannot all be true, none of which can be left out; or None.

        An empty list where the clauses have no solution whatever is assumed.
        """
        with _solver(self.blocks) as solver:
            if solver.solve(assumptions=np.asarray(assumed, np.int64).ravel().tolist()):
                return None
            core = list(solver.get_core() or [])
            for literal in list(core):
                rest = [kept for kept in core if kept != literal]
                if not solver.solve(assumptions=rest):
                    core = rest
            return core

    def violated(self, values: Truth) -> int | None:
        """Number of the first clause that the values make false, in the order of the DIMACS file; or None."""
        values = np.asarray(values, bool)
        if values.shape != (self.count + 1,):
            raise TilewrightValueError(
                f"has shape {values.shape}; {self.count} variables need ({self.count + 1},)",
                argument="values",
                value=values.shape,
            )
        before = 0
        for block in self.blocks:
            holds = (values[np.abs(block)] == (block > 0)).any(axis=1)
            if not holds.all():
                return before + int(np.argmin(holds))
            before += len(block)
        return None

    def dimacs(self, comments: tuple[str, ...] = ()) -> str:
        """The formula in the DIMACS format that SAT solvers read (``.cnf``)."""
        lines = [f"c {line}" for line in comments]
        lines.append(f"p cnf {self.count} {len(self)}")
        lines += [" ".join(map(str, clause)) + " 0" for block in self.blocks for clause in block.tolist()]
        return "\n".join(lines) + "\n"

    def values_of(self, answer: str) -> Truth | None:
        """Values in the text another solver printed (its ``v`` lines); None where it says UNSATISFIABLE.

        They are not checked; see `violated`.
        """
        check_type("answer", answer, str, "a str")
        lines = [line.split() for line in answer.splitlines() if line.strip()]
        if ["s", "UNSATISFIABLE"] in lines:
            return None
        words = [word for line in lines if line[0] == "v" for word in line[1:]]
        try:
            literals = np.array(words, dtype="U").astype(np.int64)
        except ValueError:
            raise TilewrightValueError(
                "has a v line that holds something but integers", argument="answer"
            ) from None
        if not len(literals) or np.abs(literals).max() > self.count:
            raise TilewrightValueError(
                f"has no v lines for {self.count} variables; expected what a SAT solver prints",
                argument="answer",
                allowed="what a SAT solver prints",
            )
        values = np.zeros(self.count + 1, bool)
        values[np.abs(literals)] = literals > 0
        return values


def need_solver() -> None:
    """Refuse to begin a search where there is no solver."""
    need_package("pysat", "a search by a SAT solver")


def _solver(blocks: list[Literals]) -> Any:
    need_solver()
    from pysat.solvers import Solver

    return Solver(name="glucose4", bootstrap_with=[clause for block in blocks for clause in block.tolist()])
