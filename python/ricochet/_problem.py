"""A problem of ricochet, for an optimiser that calls it."""

from __future__ import annotations

import ctypes
import functools
import os
from typing import Any, List, NoReturn, Optional, Tuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._library import Error, last_error, library
from ._results import Evaluated, RunOver, TrueValues, Variable

_UNLIMITED = 2**63 - 1
_Vector = NDArray[numpy.float64]


def problems() -> List[str]:
    """The names of all problems.

    >>> "top-speed-C1" in ricochet.problems()
    True
    """
    names: List[str] = []
    while (name := library().ricochet_problem_name(len(names))) is not None:
        names.append(name.decode())
    return names


class Problem:
    """An open problem. One thread at a time may use it; `close` it, or use it in `with`.

    name: str. unit: of the objective, "" if it has none.
    variables: a Variable for each, with name and unit.
    dimension, constraints, equalities: how many; the equalities are the first constraints and must
    be 0, the others <= 0, all to within 1e-6.
    has_derivatives: whether `derivatives`, `gradient` and `jacobian` may be called.
    has_residuals: whether `residuals` and `residual_jacobian` may be called.
    lower, upper, start: arrays of shape (dimension,), in the units of the variables.
    best_known: the best true objective of a feasible point that is known, or None.
    tolerance: the gap to it that still counts as solved.

    Evaluations are counted as the suite does: a point costs 1, with derivatives 1 + dimension.
    Asking for several parts of one point, one after the other, costs it once. Points outside the
    box are evaluated at their projection onto it.

    A pickled copy is the same problem, opened again with the evaluations that are left, the seed
    from its beginning. Every copy spends them for itself, as each of SciPy's workers does.

    >>> problem = ricochet.problem("top-speed-C1", budget=100)
    >>> problem.values(5.0)
    (-5.0, array([-2.]))
    >>> problem.remaining
    99
    """

    _problem: Optional[int] = None  # until it is open, and after it was closed

    def __init__(
        self,
        name: str,
        formulation: str = "",
        *,
        instance: int = 0,
        budget: Optional[int] = None,
        seed: int = 0,
        scene: Optional[str | os.PathLike[str]] = None,
    ) -> None:
        """Opens the problem of this name; `ricochet.problem` is the same.

        formulation: such as "count", "surrogate" or "penalised-count"; "" for the true objective.
        instance: 0 as stated; 1, 2, ... the same problem in another box, moved and reflected.
        budget: evaluations, after which RunOver is raised; None for no limit.
        seed: of `uniform`, from 0 to 2**64 - 1.
        scene: a machine file; the problems are then those of its machine, such as
        "profile-count-8-scene". The first one takes about a second.

        Raises Error if there is no such problem or formulation, with what may have been meant, and
        if the machine file is not valid.

        >>> ricochet.problem("hs-71").best_known
        17.014017289156303
        >>> ricochet.problem("hs-71", "surrogate")
        Traceback (most recent call last):
        ricochet.Error: surrogate: hs-71 has no such formulation; allowed: original, penalised
        """
        ask = library()
        asked = (
            name.encode(),
            formulation.encode(),
            _within("instance", instance, 0, 2**31 - 1),
            _UNLIMITED if budget is None else _within("budget", budget, 1, _UNLIMITED),
            _within("seed", seed, 0, 2**64 - 1),
        )
        if scene is None:
            opened = ask.ricochet_open(*asked)
        else:
            opened = ask.ricochet_open_scene(os.fsencode(scene), *asked)
        if not opened:
            raise Error(last_error())
        self._problem = opened
        self._opened_by = (name, formulation, instance, budget, seed, scene)
        self.name: str = ask.ricochet_name(opened).decode()
        self.unit: str = ask.ricochet_unit(opened).decode()
        self.dimension: int = ask.ricochet_dimension(opened)
        self.constraints: int = ask.ricochet_constraints(opened)
        self.equalities: int = ask.ricochet_equalities(opened)
        self.has_derivatives = bool(ask.ricochet_has_derivatives(opened))
        self.has_residuals = bool(ask.ricochet_has_residuals(opened))
        self.variables = tuple(
            Variable(
                ask.ricochet_variable_name(opened, k).decode(),
                ask.ricochet_variable_unit(opened, k).decode(),
            )
            for k in range(self.dimension)
        )
        best: float = ask.ricochet_best_known(opened)
        self.best_known = best if best == best else None
        self.tolerance: float = ask.ricochet_tolerance(opened)
        self.lower, self.upper, self.start = numpy.empty((3, self.dimension))
        ask.ricochet_bounds(opened, self.lower.ctypes.data, self.upper.ctypes.data)
        ask.ricochet_start(opened, self.start.ctypes.data)
        for vector in (self.lower, self.upper, self.start):
            vector.flags.writeable = False
        self._prepare(ask)

    def _prepare(self, ask: ctypes.CDLL) -> None:
        """Makes room for points and results: addresses are slow to come by."""
        self._ask_values = ask.ricochet_values
        self._ask_derivatives = ask.ricochet_derivatives
        self._x = numpy.empty(self.dimension)
        self._told_objective = numpy.empty(1)
        self._told_constraints = numpy.empty(self.constraints)
        self._told_gradient = numpy.empty(self.dimension)
        self._told_jacobian = numpy.empty((self.constraints, self.dimension))
        self._at_x = self._x.ctypes.data
        self._at_objective = self._told_objective.ctypes.data
        self._at_constraints = self._told_constraints.ctypes.data
        self._at_gradient = self._told_gradient.ctypes.data
        self._at_jacobian = self._told_jacobian.ctypes.data

    def _open(self) -> int:
        if self._problem is None:
            raise Error(f"{self.name} is closed")
        return self._problem

    def _take(self, x: ArrayLike) -> int:
        """Takes over a point. One that is not finite would end the run: it is refused here."""
        opened = self._open()
        x = numpy.asarray(x, dtype=float)
        if x.shape != self._x.shape and not (x.ndim == 0 and self.dimension == 1):
            raise ValueError(f"x must be of shape {self._x.shape}, not {x.shape}")
        if not numpy.isfinite(x).all():
            raise ValueError(f"x must be finite, not {x}")
        self._x[...] = x
        return opened

    def _values(
        self, x: ArrayLike, at_objective: Optional[int], at_constraints: Optional[int]
    ) -> None:
        if self._ask_values(self._take(x), self._at_x, at_objective, at_constraints):
            self._refused()

    def _derivatives(self, x: ArrayLike, *addresses: Optional[int]) -> None:
        if not self.has_derivatives:
            raise Error(f"{self.name} has no derivatives in this formulation")
        if self._ask_derivatives(self._take(x), self._at_x, *addresses):
            self._refused()

    def _count_residuals(self, x: ArrayLike) -> int:
        if not self.has_residuals:
            raise Error(f"{self.name} has no residuals in this formulation")
        count: int = library().ricochet_residual_count(self._take(x), self._at_x)
        if not count:
            self._refused()
        return count

    def _residuals(self, told: _Vector, *addresses: Optional[int]) -> _Vector:
        if library().ricochet_residuals(self._problem, self._at_x, *addresses):
            self._refused()
        return told

    def _refused(self) -> NoReturn:
        raise (RunOver if self.remaining == 0 else Error)(last_error())

    def __call__(self, x: ArrayLike) -> float:
        """The objective at x of a problem without constraints.

        >>> ricochet.problem("count-C1")(5.0)
        5.0
        """
        if self.constraints:
            raise TypeError(
                f"{self.name} has {self.constraints} constraints: ask for values(x), or for"
                " objective(x) and constraint_values(x)"
            )
        return self.objective(x)

    def objective(self, x: ArrayLike) -> float:
        """The objective at x, of shape (dimension,)."""
        self._values(x, self._at_objective, None)
        return self._told_objective.item()

    def constraint_values(self, x: ArrayLike) -> _Vector:
        """The constraints at x, of shape (constraints,): equalities first, the others <= 0."""
        self._values(x, None, self._at_constraints)
        return self._told_constraints.copy()

    def values(self, x: ArrayLike) -> Tuple[float, _Vector]:
        """Objective and constraints at x, the latter of shape (constraints,).

        >>> ricochet.problem("hs-71").values([1, 5, 5, 1])
        (16.0, array([12.,  0.]))
        """
        self._values(x, self._at_objective, self._at_constraints)
        return self._told_objective.item(), self._told_constraints.copy()

    def batch(self, points: ArrayLike) -> Evaluated:
        """The values at many points, of shape (points, dimension), in one call of the library.

        Each point costs one evaluation. Raises RunOver, and evaluates nothing, if fewer are left.

        >>> ricochet.problem("count-C1").batch([[3.0], [5.0], [9.0]]).objectives
        array([5., 5., 8.])
        """
        opened = self._open()
        many = numpy.ascontiguousarray(points, dtype=float)
        if many.ndim != 2 or many.shape[1] != self.dimension:
            raise ValueError(f"points must be of shape (n, {self.dimension}), not {many.shape}")
        if not numpy.isfinite(many).all():
            raise ValueError("points must be finite")
        if len(many) > self.remaining:
            raise RunOver(f"{len(many)} points, but {self.remaining} evaluations are left")
        told = Evaluated(numpy.empty(len(many)), numpy.empty((len(many), self.constraints)))
        if library().ricochet_values_batch(
            opened, many.ctypes.data, len(many), *(each.ctypes.data for each in told)
        ) < len(many):
            self._refused()
        return told

    def gradient(self, x: ArrayLike) -> _Vector:
        """The gradient of the objective at x, of shape (dimension,).

        >>> ricochet.problem("hs-71").gradient([1, 5, 5, 1])
        array([12.,  1.,  2., 11.])
        """
        self._derivatives(x, None, None, self._at_gradient, None)
        return self._told_gradient.copy()

    def jacobian(self, x: ArrayLike) -> _Vector:
        """The Jacobian of the constraints at x, of shape (constraints, dimension)."""
        self._derivatives(x, None, None, None, self._at_jacobian)
        return self._told_jacobian.copy()

    def derivatives(self, x: ArrayLike) -> Tuple[float, _Vector, _Vector, _Vector]:
        """Objective, constraints, gradient and Jacobian at x, as `values`, `gradient` and
        `jacobian` return them."""
        self._derivatives(
            x, self._at_objective, self._at_constraints, self._at_gradient, self._at_jacobian
        )
        return (
            self._told_objective.item(),
            self._told_constraints.copy(),
            self._told_gradient.copy(),
            self._told_jacobian.copy(),
        )

    def residuals(self, x: ArrayLike) -> _Vector:
        """The residuals at x, of shape (residuals,). Costs 1 evaluation. Half the sum of their
        squares is the objective, or a smooth surrogate of it.

        >>> ricochet.problem("least-squares-01-linear-full-rank-9x45").residuals([1.0] * 9).shape
        (45,)
        """
        told = numpy.empty(self._count_residuals(x))
        return self._residuals(told, told.ctypes.data, None)

    def residual_jacobian(self, x: ArrayLike) -> _Vector:
        """The Jacobian of the residuals at x, of shape (residuals, dimension). Costs 1 + dimension
        evaluations, or dimension if the residuals at x were asked for just before."""
        told = numpy.empty((self._count_residuals(x), self.dimension))
        return self._residuals(told, None, told.ctypes.data)

    def judge(self, x: ArrayLike) -> TrueValues:
        """What the suite scores x by. Costs no evaluation.

        >>> ricochet.problem("top-speed-C1", "penalised-surrogate").judge(5.0)
        TrueValues(objective=-5.0, violation=0.0)
        """
        violation = ctypes.c_double()
        if library().ricochet_judge(
            self._take(x), self._at_x, self._at_objective, ctypes.byref(violation)
        ):
            raise Error(last_error())
        return TrueValues(self._told_objective.item(), violation.value)

    def uniform(self) -> float:
        """A number uniform in [0, 1), from the seed."""
        number: float = library().ricochet_uniform(self._open())
        return number

    @property
    def remaining(self) -> int:
        """Evaluations left."""
        left: int = library().ricochet_remaining(self._open())
        return left

    def close(self) -> None:
        """Releases what the problem holds; nothing may be asked afterwards."""
        opened, self._problem = self._problem, None
        if opened:
            library().ricochet_close(opened)

    def __reduce__(self) -> Tuple[Any, ...]:
        name, formulation, instance, budget, seed, scene = self._opened_by
        left = None if budget is None else self.remaining
        if left == 0:
            raise RunOver(f"{self.name} cannot be copied: its budget is spent")
        self._open()
        options = {"instance": instance, "budget": left, "seed": seed, "scene": scene}
        return functools.partial(Problem, name, formulation, **options), ()

    def __enter__(self) -> Problem:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def __del__(self) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<ricochet.Problem {self.name}{'' if self._problem else ', closed'}>"


problem = Problem


def _within(what: str, number: int, lowest: int, highest: int) -> int:
    if not lowest <= number <= highest:
        raise ValueError(f"{what} {number}: must be from {lowest} to {highest}")
    return number
