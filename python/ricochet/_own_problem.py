"""A problem of a user's own: functions of a point."""

from __future__ import annotations

from typing import Any, Callable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

_Vector = NDArray[numpy.float64]
_Function = Callable[[_Vector], Any]
_Constraint = Union[_Function, Tuple[_Function, str], Tuple[_Function, str, _Function]]

_SENSES = {"<=0": 1.0, ">=0": -1.0, "==0": 1.0, "=0": 1.0}
_TOLERANCE = 1e-6  # of a constraint, as in the suite


class Constraint(NamedTuple):
    function: _Function
    is_equality: bool
    sign: float  #: times the function is what must be <= 0
    gradient: Optional[_Function]


class Problem:
    """A problem of your own, for `minimise` and `compare`.

    f: a function of an array of shape (dimension,), which returns a number; None with `residuals`.
    lower, upper: the bounds, finite, of shape (dimension,).
    start: within the bounds; the middle of the box if it is not given.
    constraints: a list of functions, each of which must be <= 0, or of pairs such as
    `(function, "<= 0")`, `(function, ">= 0")`, `(function, "== 0")`; a violation of up to 1e-6 is
    allowed. A third entry is the function's gradient.
    gradient: of f, of shape (dimension,). Each constraint then needs its own.
    gradient_cost: what it is charged beside the value, in evaluations; if it is not given, as many
    as there are variables.
    residuals: a function that returns an array; the value is half the sum of their squares. It is
    evaluated once at the start to know how many there are, which is then the same at every point.
    jacobian: their derivatives, of shape (residuals, dimension).
    maximise: f is to be large.
    jumps: values jump, as counts do: `solver="auto"` then chooses another solver.
    noise: a point has another value each time: `minimise` then evaluates its best point again.
    name: in the tables of `compare`; that of f if it is not given.

    A function gets an array of its own for each call. One that raises an exception or returns NaN
    costs that evaluation alone. f and then the constraints are called with the same point: if one
    simulation gives all of them, remember its last answer.

    >>> import functools
    >>> def simulated(x):
    ...     return {"cost": x[0] + x[1], "strength": x[0] * x[1]}
    >>> last = functools.lru_cache(maxsize=1)(lambda *x: simulated(x))
    >>> problem = ricochet.Problem(
    ...     lambda x: last(*x)["cost"], [0.1, 0.1], [5, 5],
    ...     constraints=[(lambda x: last(*x)["strength"] - 1, ">= 0")])
    >>> round(ricochet.minimise(problem).value, 4)
    2.0
    """

    def __init__(
        self,
        f: Optional[_Function] = None,
        lower: ArrayLike = (),
        upper: ArrayLike = (),
        *,
        start: Optional[ArrayLike] = None,
        constraints: Sequence[_Constraint] = (),
        gradient: Optional[_Function] = None,
        gradient_cost: Optional[int] = None,
        residuals: Optional[_Function] = None,
        jacobian: Optional[_Function] = None,
        maximise: bool = False,
        jumps: bool = False,
        noise: bool = False,
        name: Optional[str] = None,
    ) -> None:
        """Raises TypeError and ValueError for what does not fit together, with what is allowed."""
        if (f is None) == (residuals is None):
            raise TypeError("give a function f, or residuals, and not both")
        given = {"f": f, "gradient": gradient, "residuals": residuals, "jacobian": jacobian}
        for what, function in given.items():
            if function is not None and not callable(function):
                raise TypeError(f"{what} must be a function, not {function!r}")
        if jacobian is not None and residuals is None:
            raise TypeError("jacobian is that of residuals, which are missing")
        if residuals is not None and gradient is not None:
            raise TypeError("give the jacobian of residuals, not a gradient")
        if residuals is not None and maximise:
            raise TypeError("residuals are minimised")
        self.lower, self.upper = _bounds(lower, upper)
        self.dimension = len(self.lower)
        self.start = (self.lower + self.upper) / 2 if start is None else _vector("start", start)
        if self.start.shape != self.lower.shape:
            raise ValueError(f"start must be of shape ({self.dimension},), not {self.start.shape}")
        for i, (low, x, high) in enumerate(zip(self.lower, self.start, self.upper)):
            if not low <= x <= high:
                raise ValueError(f"start[{i}] = {x}: must be from {low} to {high}")
        listed = [_constraint(k, each) for k, each in enumerate(constraints)]
        # The library wants equalities first.
        self.constraints: List[Constraint] = sorted(listed, key=lambda each: not each.is_equality)
        self.equalities = sum(each.is_equality for each in listed)
        derivative = gradient or jacobian
        lacking = [k for k, each in enumerate(listed) if each.gradient is None]
        if derivative and lacking:
            raise ValueError(
                f"constraints[{lacking[0]}] has no gradient, but the objective has one: give"
                ' (function, "<= 0", gradient)'
            )
        if gradient_cost is not None and gradient_cost < 1:
            raise ValueError(f"gradient_cost {gradient_cost}: must be >= 1")
        self.f, self.gradient, self.residuals, self.jacobian = f, gradient, residuals, jacobian
        self.gradient_cost = gradient_cost
        self._residual_count = 0  # not known yet
        self.sign = -1.0 if maximise else 1.0
        self.maximise, self.jumps, self.noise = maximise, jumps, noise
        self.has_derivatives = derivative is not None
        own = getattr(f or residuals, "__name__", "problem")
        self.name: str = name if name is not None else own if own.isidentifier() else "problem"

    def value(self, x: _Vector) -> float:
        """Of f at x."""
        if self.residuals is not None:
            return half_squares(self.residuals_at(x))
        assert self.f is not None
        return float(self.f(x.copy()))

    def constraint_values(self, x: _Vector) -> _Vector:
        """As the library wants them: equalities first, the others <= 0."""
        return numpy.array([c.sign * float(c.function(x.copy())) for c in self.constraints])

    def violation(self, constraints: _Vector) -> float:
        """The largest, 0 if there is none of more than the tolerance."""
        if not len(constraints):
            return 0.0
        broken = constraints.copy()
        broken[: self.equalities] = abs(broken[: self.equalities])
        largest = float(broken.max())  # NaN if one is
        return 0.0 if largest <= _TOLERANCE else largest

    def gradient_at(self, x: _Vector) -> _Vector:
        """Of f."""
        return shaped("gradient", self._of(self.gradient)(x.copy()), (self.dimension,))

    def constraint_jacobian(self, x: _Vector) -> _Vector:
        """Of shape (constraints, dimension), signed as constraint_values."""
        rows = [
            c.sign * shaped("gradient of a constraint", self._of(c.gradient)(x.copy()), x.shape)
            for c in self.constraints
        ]
        return numpy.array(rows).reshape(len(rows), self.dimension)

    def residuals_at(self, x: _Vector) -> _Vector:
        told = _vector("residuals", self._of(self.residuals)(x.copy()), finite=False)
        self._residual_count = self._residual_count or len(told)
        return shaped("residuals", told, (self._residual_count,))

    def residual_count(self) -> int:
        """How many there are. Raises what the user's function raises at the start."""
        if self.residuals is not None and not self._residual_count:
            self.residuals_at(self.start)
        return self._residual_count

    def jacobian_at(self, x: _Vector) -> _Vector:
        return numpy.atleast_2d(numpy.asarray(self._of(self.jacobian)(x.copy()), dtype=float))

    def __repr__(self) -> str:
        of = f"{self.dimension} variables, {len(self.constraints)} constraints"
        return f"<ricochet.Problem {self.name}, {of}>"

    @staticmethod
    def _of(function: Optional[_Function]) -> _Function:
        assert function is not None
        return function


def half_squares(residuals: _Vector) -> float:
    return float(residuals @ residuals) / 2


def shaped(what: str, array: ArrayLike, shape: Tuple[int, ...]) -> _Vector:
    """The array, if it has this shape. Raises ValueError."""
    numbers = numpy.atleast_1d(numpy.asarray(array, dtype=float))
    if numbers.shape != shape:
        raise ValueError(f"{what} must be of shape {shape}, not {numbers.shape}")
    return numbers


def _vector(what: str, array: ArrayLike, finite: bool = True) -> _Vector:
    numbers = numpy.array(array, dtype=float, ndmin=1)
    if numbers.ndim != 1 or not len(numbers):
        raise ValueError(f"{what} must be a list of numbers, not of shape {numbers.shape}")
    if finite and not numpy.isfinite(numbers).all():
        raise ValueError(f"{what} must be finite, not {numbers}")
    return numbers


def _bounds(lower: ArrayLike, upper: ArrayLike) -> Tuple[_Vector, _Vector]:
    low, high = _vector("lower", lower), _vector("upper", upper)
    if low.shape != high.shape:
        raise ValueError(f"lower has {len(low)} numbers, upper {len(high)}")
    for i, (a, b) in enumerate(zip(low, high)):
        if a > b:
            raise ValueError(f"upper[{i}] = {b}: must be >= lower[{i}] = {a}")
    return low, high


def _constraint(place: int, item: Any) -> Constraint:
    where = f"constraints[{place}]"
    if callable(item):
        return Constraint(item, False, 1.0, None)
    if isinstance(item, dict):  # of SciPy, where "ineq" is >= 0
        raise TypeError(f'{where}: give a pair (function, ">= 0"), not a dictionary')
    if not isinstance(item, tuple) or len(item) not in (2, 3) or not callable(item[0]):
        raise TypeError(f'{where}: must be a function or a pair (function, "<= 0"), not {item!r}')
    sense = "".join(item[1].split()) if isinstance(item[1], str) else item[1]
    if sense not in _SENSES:
        raise ValueError(f'{where}: {item[1]!r}; allowed are "<= 0", ">= 0", "== 0"')
    if len(item) == 3 and not callable(item[2]):
        raise TypeError(f"{where}: its gradient must be a function, not {item[2]!r}")
    gradient = item[2] if len(item) == 3 else None
    return Constraint(item[0], sense.strip("=0") == "", _SENSES[sense], gradient)
