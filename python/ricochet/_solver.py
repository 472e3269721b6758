"""A Python function as a solver: the program's side of the line protocol."""

from __future__ import annotations

import io
import json
import math
import os
import sys
from typing import Any, Callable, Dict, List, NoReturn, Optional, Set, Tuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._results import Evaluated, RunOver

_Vector = NDArray[numpy.float64]


def solver(
    minimise: Callable[[SearchedProblem], Any],
    *,
    name: str,
    version: str = "",
    takes_constraints: int = 0,
    needs_derivatives: bool = False,
    needs_residuals: bool = False,
    stochastic: bool = False,
) -> None:
    """Runs this program as a solver that ricochet calls, until ricochet has no more problems.

    Write a file mine.py, then `ricochet compare --solver "python3 mine.py"`:

        def minimise(problem):
            return scipy.optimize.minimize(problem, problem.start, method="Powell")

        ricochet.solver(minimise, name="powell")

    minimise: is called with a SearchedProblem for each start. It returns the point, or the point and
    why it ended, or what SciPy returns, or None for the best evaluated point. RunOver is raised
    through it when the budget is spent.
    takes_constraints: 0 none, they arrive as a penalty; 1 inequalities; 2 also equalities.
    stochastic: whether it draws random numbers, which `problem.seed` must determine.

    What `minimise` prints goes to standard error. Needs no library of ricochet.
    """
    lines = _Lines()
    lines.say(
        {
            "name": name,
            "version": version,
            "takes_constraints": takes_constraints,
            "needs_derivatives": needs_derivatives,
            "needs_residuals": needs_residuals,
            "stochastic": stochastic,
        }
    )
    while (stated := lines.heard()) is not None:
        try:
            lines.say(_done(minimise(SearchedProblem(stated, lines))))
        except RunOver:
            lines.say({"done": "stopped"})


class SearchedProblem:
    """A problem as ricochet shows it to a solver: within a box, minimise from `start`.

    name: str.
    dimension, constraints, equalities: how many; the equalities are the first constraints and must
    be 0, the others <= 0, all to within 1e-6.
    has_derivatives, has_residuals: whether these may be asked for.
    lower, upper, start: arrays of shape (dimension,).
    budget: evaluations in all; remaining: evaluations left, after the last answer.
    seed: for a random generator, below 2**32.

    Asking for several parts of one point, one after the other, costs one evaluation; asking for a
    part again costs another, as it does in every language.
    """

    def __init__(self, stated: Dict[str, Any], lines: _Lines) -> None:
        self._lines = lines
        # The last point, its answer, and what was asked of it.
        self._last: Tuple[Any, Dict[str, Any], Set[str]] = (None, {}, set())
        self._over = False
        self.name: str = stated["name"]
        self.dimension: int = stated["dimension"]
        self.constraints: int = stated["constraints"]
        self.equalities: int = stated["equalities"]
        self.has_derivatives: bool = stated["derivatives"]
        self.has_residuals: bool = stated["residuals"]
        self.lower = _numbers(stated["lower"])
        self.upper = _numbers(stated["upper"])
        self.start = _numbers(stated["start"])
        self.budget: int = stated["budget"]
        self.remaining: int = stated["budget"]
        self.seed: int = stated["seed"]

    def __call__(self, x: ArrayLike) -> float:
        """The objective at x."""
        return self.objective(x)

    def objective(self, x: ArrayLike) -> float:
        """The objective at x; infinite if it is not a number."""
        return _number(self._asked(x, {"objective"})["objective"])

    def constraint_values(self, x: ArrayLike) -> _Vector:
        """The constraints at x, of shape (constraints,)."""
        return _numbers(self._asked(x, {"constraints"})["constraints"])

    def values(self, x: ArrayLike) -> Tuple[float, _Vector]:
        """Objective and constraints at x."""
        answer = self._asked(x, {"objective", "constraints"})
        return _number(answer["objective"]), _numbers(answer["constraints"])

    def gradient(self, x: ArrayLike) -> _Vector:
        """The gradient of the objective at x, of shape (dimension,)."""
        return _numbers(self._asked(x, {"gradient"}, derivatives=True)["gradient"])

    def jacobian(self, x: ArrayLike) -> _Vector:
        """The Jacobian of the constraints at x, of shape (constraints, dimension)."""
        rows = self._asked(x, {"jacobian"}, derivatives=True)["jacobian"]
        return _numbers(rows).reshape(self.constraints, self.dimension)

    def residuals(self, x: ArrayLike) -> _Vector:
        """The residuals at x, of whose squares the objective is half the sum."""
        return _numbers(self._asked(x, {"residuals"}, residuals=True)["residuals"])

    def residual_jacobian(self, x: ArrayLike) -> _Vector:
        """Their Jacobian at x, of shape (residuals, dimension)."""
        answer = self._asked(x, {"residual_jacobian"}, residuals=True, derivatives=True)
        return _numbers(answer["residual_jacobian"])

    def batch(self, points: ArrayLike) -> Evaluated:
        """Objectives and constraints at many points, of shape (points, dimension), in one
        question, which saves most of what a question takes."""
        many = [[_sent(x) for x in point] for point in numpy.asarray(points, dtype=float)]
        if not many:
            return Evaluated(numpy.empty(0), numpy.empty((0, self.constraints)))
        answer = self._answer({"ask": many})
        constraints = [_numbers(each) for each in answer["constraints"]]
        return Evaluated(
            numpy.array([_number(each) for each in answer["objective"]]),
            numpy.array(constraints).reshape(len(many), self.constraints),
        )

    def _asked(self, x: ArrayLike, parts: Set[str], **options: bool) -> Dict[str, Any]:
        """The answer at x, which has these parts: the last one, if it has and was not asked for
        any of them before."""
        point = [float(each) for each in numpy.atleast_1d(numpy.asarray(x, dtype=float))]
        at, answer, asked = self._last
        again = at == point and bool(parts & asked)
        known = at == point and not again
        if not (known and parts <= answer.keys()):
            answer = self._answer({"ask": [_sent(each) for each in point], **options})
        self._last = (point, answer, parts | asked if known else parts)
        return answer

    def _answer(self, question: Dict[str, Any]) -> Dict[str, Any]:
        if self._over:
            self._stop()
        self._lines.say(question)
        answer = self._lines.heard()
        if answer is None or "stop" in answer:
            self._stop()
        self.remaining = answer["remaining"]
        return answer

    def _stop(self) -> NoReturn:
        self._over = True
        self.remaining = 0
        raise RunOver("the run is over: its budget is spent")


class _Lines:
    """The lines to and from ricochet. Standard output is theirs; what others print there goes to
    standard error."""

    def __init__(self) -> None:
        sys.stdout.flush()
        self._to = os.fdopen(os.dup(1), "wb", buffering=0)
        self._from = sys.stdin.buffer
        os.dup2(2, 1)
        if isinstance(sys.stdout, io.TextIOWrapper):
            # At once: what is kept is lost if the program is killed.
            sys.stdout.reconfigure(line_buffering=True)

    def say(self, message: Dict[str, Any]) -> None:
        self._to.write(json.dumps(message, allow_nan=False).encode() + b"\n")

    def heard(self) -> Optional[Dict[str, Any]]:
        """The next message; None at the end."""
        line = self._from.readline()
        return json.loads(line) if line else None


def _done(found: Any) -> Dict[str, Any]:
    """The last message of a run, of what the function returned."""
    if found is None:
        return {"done": "done"}
    why = "done"
    if hasattr(found, "x"):
        found, why = found.x, getattr(found, "message", why)
    elif isinstance(found, tuple) and len(found) == 2 and isinstance(found[1], str):
        found, why = found
    point: List[Any] = [_sent(each) for each in numpy.atleast_1d(numpy.asarray(found, dtype=float))]
    return {"done": str(why), "point": point}


def _sent(number: float) -> Optional[float]:
    return float(number) if math.isfinite(number) else None


def _number(told: Optional[float]) -> float:
    return math.inf if told is None else told


def _numbers(told: Any) -> _Vector:
    """null stands for a number that is not finite, here NaN."""
    return numpy.array(told, dtype=float)
