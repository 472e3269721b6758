"""A problem of ricochet, for an optimiser that calls it."""

from __future__ import annotations

import functools
import os
from typing import Any, List, Optional, Tuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._calls import Calls
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


class SuiteProblem:
    """An open problem of the suite, as `ricochet.problem` returns it. `close` it, or use it in `with`. Several threads may use it at once: the
    library evaluates for one after the other.

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
    Asking for several parts of one point, one after the other, costs it once, unless another
    thread asks in between. Points outside the
    box are evaluated at their projection onto it.

    A pickled copy is the same problem, opened again with the evaluations that are left, the seed
    from its beginning. Every copy spends them for itself, as each of SciPy's workers does.

    >>> problem = ricochet.problem("top-speed-C1", budget=100)
    >>> problem.values(5.0)
    (-5.0, array([-2.]))
    >>> problem.remaining
    99
    """

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
        self._calls = Calls(opened)
        self._opened_by = (name, formulation, instance, budget, seed, scene)
        self.name = self._calls.name
        self.unit: str = ask.ricochet_unit(opened).decode()
        self.dimension = self._calls.dimension
        self.constraints = self._calls.constraint_count
        self.equalities: int = ask.ricochet_equalities(opened)
        self.has_derivatives = self._calls.has_derivatives
        self.has_residuals = self._calls.has_residuals
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
        room = self._calls.room
        self._calls.values(x, room, room.at_objective, None)
        return room.objective.item()

    def constraint_values(self, x: ArrayLike) -> _Vector:
        """The constraints at x, of shape (constraints,): equalities first, the others <= 0."""
        room = self._calls.room
        self._calls.values(x, room, None, room.at_constraints)
        return room.constraints.copy()

    def values(self, x: ArrayLike) -> Tuple[float, _Vector]:
        """Objective and constraints at x, the latter of shape (constraints,).

        >>> ricochet.problem("hs-71").values([1, 5, 5, 1])
        (16.0, array([12.,  0.]))
        """
        room = self._calls.room
        self._calls.values(x, room, room.at_objective, room.at_constraints)
        return room.objective.item(), room.constraints.copy()

    def batch(self, points: ArrayLike) -> Evaluated:
        """The values at many points, of shape (points, dimension), in one call of the library.

        Each point costs one evaluation. Raises RunOver, and evaluates nothing, if fewer are left.

        >>> ricochet.problem("count-C1").batch([[3.0], [5.0], [9.0]]).objectives
        array([5., 5., 8.])
        """
        return self._calls.batch(points)

    def gradient(self, x: ArrayLike) -> _Vector:
        """The gradient of the objective at x, of shape (dimension,).

        >>> ricochet.problem("hs-71").gradient([1, 5, 5, 1])
        array([12.,  1.,  2., 11.])
        """
        room = self._calls.room
        self._calls.derivatives(x, room, None, None, room.at_gradient, None)
        return room.gradient.copy()

    def jacobian(self, x: ArrayLike) -> _Vector:
        """The Jacobian of the constraints at x, of shape (constraints, dimension)."""
        room = self._calls.room
        self._calls.derivatives(x, room, None, None, None, room.at_jacobian)
        return room.jacobian.copy()

    def derivatives(self, x: ArrayLike) -> Tuple[float, _Vector, _Vector, _Vector]:
        """Objective, constraints, gradient and Jacobian at x, as `values`, `gradient` and
        `jacobian` return them."""
        room = self._calls.room
        self._calls.derivatives(
            x, room, room.at_objective, room.at_constraints, room.at_gradient, room.at_jacobian
        )
        return (
            room.objective.item(),
            room.constraints.copy(),
            room.gradient.copy(),
            room.jacobian.copy(),
        )

    def residuals(self, x: ArrayLike) -> _Vector:
        """The residuals at x, of shape (residuals,). Costs 1 evaluation. Half the sum of their
        squares is the objective, or a smooth surrogate of it.

        >>> ricochet.problem("least-squares-01-linear-full-rank-9x45").residuals([1.0] * 9).shape
        (45,)
        """
        told = numpy.empty(self._calls.residual_count(x))
        return self._calls.residuals(told, told.ctypes.data, None)

    def residual_jacobian(self, x: ArrayLike) -> _Vector:
        """The Jacobian of the residuals at x, of shape (residuals, dimension). Costs 1 + dimension
        evaluations, or dimension if the residuals at x were asked for just before."""
        told = numpy.empty((self._calls.residual_count(x), self.dimension))
        return self._calls.residuals(told, None, told.ctypes.data)

    def judge(self, x: ArrayLike) -> TrueValues:
        """What the suite scores x by. Costs no evaluation.

        >>> ricochet.problem("top-speed-C1", "penalised-surrogate").judge(5.0)
        TrueValues(objective=-5.0, violation=0.0)
        """
        return self._calls.judge(x)

    def uniform(self) -> float:
        """A number uniform in [0, 1), from the seed."""
        number: float = library().ricochet_uniform(self._calls.handle())
        return number

    @property
    def remaining(self) -> int:
        """Evaluations left."""
        return self._calls.remaining()

    def close(self) -> None:
        """Releases what the problem holds; nothing may be asked afterwards."""
        self._calls.close()

    def __reduce__(self) -> Tuple[Any, ...]:
        name, formulation, instance, budget, seed, scene = self._opened_by
        self._calls.handle()  # raises Error if it is closed
        left = None if budget is None else self.remaining
        if left == 0:
            raise RunOver(f"{self.name} cannot be copied: its budget is spent")
        options = {"instance": instance, "budget": left, "seed": seed, "scene": scene}
        return functools.partial(SuiteProblem, name, formulation, **options), ()

    def __enter__(self) -> SuiteProblem:
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<ricochet.SuiteProblem {self.name}{'' if self._calls.opened else ', closed'}>"


problem = SuiteProblem


def _within(what: str, number: int, lowest: int, highest: int) -> int:
    if not lowest <= number <= highest:
        raise ValueError(f"{what} {number}: must be from {lowest} to {highest}")
    return number
