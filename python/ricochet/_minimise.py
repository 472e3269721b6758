"""Solvers of the suite on a function of the user's."""

from __future__ import annotations

import dataclasses
import random
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Union

import numpy
from numpy.typing import NDArray

from ._library import Error
from ._own_problem import Problem
from ._run import Run, warn

if TYPE_CHECKING:
    import pandas

_Vector = NDArray[numpy.float64]
_TARGETS = 10.0 ** -numpy.arange(1, 7)  # shares of the way from the start to the best value


@dataclasses.dataclass(frozen=True)
class Result:
    """What `minimise` found.

    x: the best evaluated point, of shape (dimension,).
    value: of f there, as f returned it; with noise it is best by luck, too.
    violation: the largest of a constraint there; 0 if x is feasible.
    evaluations: that were charged to the budget: 1 for values, and what a gradient costs beside.
    failed: how many calls had no value. failures: how many, by message.
    seconds: of processor time, the function's included.
    solver: that ran, and why, if "auto" chose it, else "".
    ended: how the run ended; "interrupted" by Ctrl-C.
    mean, standard_error: of further evaluations at x, if the problem has noise, else None.
    """

    x: _Vector
    value: float
    violation: float
    evaluations: int
    failed: int
    failures: Dict[str, int]
    seconds: float
    solver: str
    why: str
    ended: str
    mean: Optional[float]
    standard_error: Optional[float]
    _run: Run = dataclasses.field(repr=False, compare=False)

    @property
    def trace(self) -> pandas.DataFrame:
        """A pandas frame with a row for each call of the function, in order: `value` (NaN if it
        failed), `violation`, `best` (the best feasible value so far), `seconds` since the start of
        the run, and the point, `x1`, `x2`, ... Needs pandas."""
        import pandas

        run, sign = self._run, self._run.problem.sign
        frame = pandas.DataFrame({"value": run.values, "violation": run.violations})
        feasible = (sign * frame["value"]).where(frame["violation"] == 0)
        frame["best"] = sign * feasible.cummin().ffill()
        frame["seconds"] = run.seconds
        points = numpy.array(run.points).reshape(len(frame), -1)
        for i in range(points.shape[1]):
            frame[f"x{i + 1}"] = points[:, i]
        return frame


def minimise(
    problem: Problem, solver: str = "auto", budget: int = 500, *, seed: int = 0
) -> Result:
    """Minimises a problem of your own in this process, or maximises it if the problem says so.

    solver: a name of `ricochet list solvers`; "auto" chooses by what the problem declares. One that
    takes no constraints sees them as a penalty.
    budget: evaluations. While some are left, the solver begins again from points uniform in the
    box.
    seed: of the random numbers, from 0 to 2**31 - 1; the same seed gives the same run, to the bit.

    An exception or NaN costs that evaluation alone: there is a warning, and a count in the result.
    Ctrl-C ends the run, and the best so far is returned, with a warning. With noise the best point
    is evaluated again, a tenth of the budget more, but 10 times at least. Raises Error if no
    evaluation has a value, or there is no such solver, with the nearest names, or it does not take
    the problem. A solver that crashes takes Python with it; a problem file runs in another process.

    >>> problem = ricochet.Problem(lambda x: 3 - (x[0] - 2) ** 2, [0], [5], maximise=True)
    >>> found = ricochet.minimise(problem, "nlopt-cobyla", budget=100)
    >>> round(found.value, 6), found.evaluations, found.failed
    (3.0, 100, 0)
    >>> ricochet.minimise(problem, "nlopt-cobila")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    ricochet.Error: solver nlopt-cobila: there is no such solver; did you mean nlopt-cobyla or ...
    """
    if not isinstance(problem, Problem):
        raise TypeError(f"problem must be a ricochet.Problem, not {problem!r}")
    run = _solved(problem, solver, problem.start, budget, seed)
    if run.interrupted:
        warn("interrupted: this is the best so far")
    best = run.best()
    if best is None:
        if run.interrupted:
            raise KeyboardInterrupt
        most = max(run.failures, key=run.failures.__getitem__, default="there was none")
        raise Error(f"no evaluation of {problem.name} has a value: {most}") from run.failure
    x = run.points[best].copy()
    again = None
    if problem.noise and not run.interrupted:
        again = _evaluated_again(problem, x, max(10, budget // 10))
    return Result(
        x=x,
        value=run.values[best],
        violation=run.violations[best],
        evaluations=run.told.evaluations,
        failed=sum(run.failures.values()),
        failures=dict(run.failures),
        seconds=run.told.seconds,
        solver=run.chosen,
        why=run.why,
        ended=run.ended,
        mean=None if again is None else float(numpy.mean(again)),
        standard_error=None
        if again is None
        else float(numpy.std(again, ddof=1)) / len(again) ** 0.5,
        _run=run,
    )


def compare(
    problems: Union[Problem, Sequence[Problem]],
    solvers: Sequence[str],
    budget: int = 500,
    *,
    starts: int = 5,
    seed: int = 0,
) -> pandas.DataFrame:
    """Runs each solver on each problem from the same starts: the problem's own, and others that are
    drawn from the seed. Returns a pandas frame with a row for each run:

    problem, solver, start (0: the problem's own); chosen: the solver that ran;
    value: the best feasible one, as f returned it, NaN if there is none;
    evaluations, failed, seconds, ended: as in Result;
    targets: share of six targets that were reached. These are, on the way from the value at the start
    to the best value that any of the runs found, all but 10, 1, 0.1, ..., 0.0001 % of it. If the
    start has no feasible value, its worst first feasible value of all solvers is taken.

    Ctrl-C ends the comparison; the frame has what was run so far. Needs pandas.

    >>> bowl = ricochet.Problem(lambda x: (x[0] - 1) ** 2 + x[1] ** 2, [-2, -2], [2, 2], name="bowl")
    >>> frame = ricochet.compare([bowl], ["nlopt-bobyqa", "random-search"], budget=100, starts=3)
    >>> frame.groupby("solver")["targets"].mean()["nlopt-bobyqa"]
    1.0
    """
    import pandas

    listed = [problems] if isinstance(problems, Problem) else list(problems)
    entries = [solvers] if isinstance(solvers, str) else list(solvers)
    names = [problem.name for problem in listed]
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"two problems have the name {name}: give each a name")
    if not entries or not listed:
        raise ValueError("at least one problem and one solver are needed")
    if starts < 1:
        raise ValueError(f"starts {starts}: must be >= 1")
    rows: List[Dict[str, Any]] = []
    for problem in listed:
        runs = []
        for k, start in enumerate(_starts(problem, starts, seed)):
            for entry in entries:
                runs.append((k, entry, _solved(problem, entry, start, budget, seed + k)))
                if runs[-1][2].interrupted:
                    break
            if runs[-1][2].interrupted:
                break
        rows += _rows(problem, runs)
        if runs[-1][2].interrupted:
            warn("interrupted: the comparison is not complete")
            break
    return pandas.DataFrame(rows)


def _solved(problem: Problem, solver: str, start: _Vector, budget: int, seed: int) -> Run:
    for what, number, lowest, highest in [
        ("budget", budget, 1, 2**63 - 1),
        ("seed", seed, 0, 2**31 - 1),
    ]:
        if not lowest <= number <= highest:
            raise ValueError(f"{what} {number}: must be from {lowest} to {highest}")
    run = Run(problem)
    run.solve(solver, start, budget, seed)
    return run


def _evaluated_again(problem: Problem, x: _Vector, times: int) -> Optional[List[float]]:
    """Values at x; None if one fails or the user interrupts."""
    try:
        return [problem.value(x) for _ in range(times)]
    except Exception as error:
        warn(f"{problem.name} has no value at the best point: {error}")
    except KeyboardInterrupt:
        warn("interrupted: the mean is not known")
    return None


def _starts(problem: Problem, count: int, seed: int) -> List[_Vector]:
    """The problem's own, and others uniform in the box."""
    draw = random.Random(seed)
    width = problem.upper - problem.lower
    others = [
        problem.lower + width * numpy.array([draw.random() for _ in range(problem.dimension)])
        for _ in range(count - 1)
    ]
    return [problem.start] + [numpy.clip(x, problem.lower, problem.upper) for x in others]


def _rows(problem: Problem, runs: Sequence[Any]) -> List[Dict[str, Any]]:
    sign = problem.sign
    found: List[float] = []  # the least signed value of each run, infinite if none is feasible
    first: Dict[int, float] = {}  # the first of each start
    for k, _, run in runs:
        values = sign * numpy.array(run.values)
        feasible = values[(numpy.array(run.violations) == 0) & ~numpy.isnan(values)]
        found.append(feasible.min() if len(feasible) else numpy.inf)
        if len(feasible):
            first[k] = max(first.get(k, -numpy.inf), feasible[0])
    best = min(found)
    rows = []
    for (k, entry, run), least in zip(runs, found):
        share = 0.0
        if numpy.isfinite(least):
            share = float(numpy.mean(least <= best + _TARGETS * (first[k] - best)))
        rows.append(
            {
                "problem": problem.name,
                "solver": entry,
                "start": k,
                "chosen": run.chosen,
                "value": sign * least + 0.0 if numpy.isfinite(least) else numpy.nan,
                "evaluations": run.told.evaluations,
                "failed": sum(run.failures.values()),
                "seconds": run.told.seconds,
                "targets": share,
                "ended": run.ended,
            }
        )
    return rows
