"""One run of a solver on a problem of a user's own, whose functions the library calls."""

from __future__ import annotations

import collections
import contextlib
import ctypes
import signal
import sys
import threading
import time
import warnings
from typing import Any, Callable, Counter, Dict, Iterator, List, Optional

import numpy
from numpy.typing import NDArray

from ._library import ABI, Error, minimise_library
from ._own_problem import Problem, half_squares, shaped

_Vector = NDArray[numpy.float64]
_WARNED = 3  # kinds of failures that are warned of at once

_int, _long, _address = ctypes.c_int32, ctypes.c_int64, ctypes.c_void_p


def warn(message: str) -> None:
    """Warns of what the call of this package has met, at its line in the user's program."""
    level, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").startswith("ricochet."):
        level, frame = level + 1, frame.f_back
    warnings.warn(message, RuntimeWarning, stacklevel=level)


def _callback(arguments: int) -> Any:
    return ctypes.CFUNCTYPE(_int, *[_address] * arguments)


class _Asked(ctypes.Structure):
    """ricochet_problem of ricochet.h."""

    _fields_ = [
        *[(n, _int) for n in ("abi", "dimension", "constraints", "equalities")],
        *[(n, _int) for n in ("has_derivatives", "has_residuals")],
        *[(n, _address) for n in ("name", "lower", "upper", "start")],
        ("values", _callback(4)),
        ("derivatives", _callback(6)),
        ("residual_count", _callback(2)),
        ("residuals", _callback(4)),
        *[(n, _address) for n in ("remaining", "uniform")],
    ]


class _Minimisation(ctypes.Structure):
    """ricochet_minimisation of minimise.h."""

    _fields_ = [
        ("abi", _int),
        ("solver", ctypes.c_char_p),
        ("budget", _long),
        *[(n, _int) for n in ("seed", "jumps")],
        ("gradient_cost", _long),
        ("point", _address),
        *[(n, ctypes.c_double) for n in ("objective", "violation")],
        *[(n, _long) for n in ("evaluations", "failed")],
        ("seconds", ctypes.c_double),
        *[(n, ctypes.c_char_p) for n in ("chosen", "why", "ended")],
    ]


class Run:
    """A run, and every call of the problem's functions in it, in order.

    points, values, violations, seconds: of each; the value is NaN where there is none.
    failures: how many failed, by message. failure: the first exception.
    interrupted: by Ctrl-C, which ends the run, as any other exception than an Exception does.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.points: List[_Vector] = []
        self.values: List[float] = []
        self.violations: List[float] = []
        self.seconds: List[float] = []
        self.failures: Counter[str] = collections.Counter()
        self.failure: Optional[Exception] = None
        self.interrupted = False
        self._raised: Optional[BaseException] = None  # what ends the run
        self._constraints = numpy.empty(0)  # the last ones
        self._last_residuals = numpy.empty(0)
        self._inside = False  # a function of the user's
        self._views: Dict[int, _Vector] = {}  # the library's arrays, which stay where they are
        self._began = time.perf_counter()

    def solve(self, solver: str, start: _Vector, budget: int, seed: int) -> None:
        """Raises Error for a solver that is not there or does not take the problem."""
        problem, library = self.problem, minimise_library()
        count = problem.residual_count()
        asked = _Asked(
            abi=ABI,
            dimension=problem.dimension,
            constraints=len(problem.constraints),
            equalities=problem.equalities,
            has_derivatives=problem.has_derivatives,
            has_residuals=problem.residuals is not None,
            lower=problem.lower.ctypes.data,
            upper=problem.upper.ctypes.data,
            start=start.ctypes.data,
            values=_callback(4)(self._guarded(self._values)),
            derivatives=_callback(6)(self._guarded(self._derivatives)),
            residual_count=_callback(2)(lambda problem, x: count),
            residuals=_callback(4)(self._guarded(self._residuals)),
        )
        point = numpy.empty(problem.dimension)
        self.told = _Minimisation(
            abi=ABI,
            solver=solver.encode(),
            budget=budget,
            seed=seed,
            jumps=problem.jumps,
            gradient_cost=problem.gradient_cost or 0,
            point=point.ctypes.data,
        )
        with self._interrupts():
            code = library.ricochet_minimise(ctypes.byref(asked), ctypes.byref(self.told))
        self.chosen: str = self.told.chosen.decode(errors="replace")
        self.why: str = self.told.why.decode(errors="replace")
        self.ended: str = self.told.ended.decode(errors="replace")
        if self._raised is not None and not isinstance(self._raised, KeyboardInterrupt):
            raise self._raised
        if code:
            raise Error(self.ended)
        if self.interrupted:
            self.ended = "interrupted"

    def best(self) -> Optional[int]:
        """The first of the best evaluations; None if none has a value."""
        values = self.problem.sign * numpy.array(self.values)
        violations = numpy.array(self.violations)
        missing = numpy.isnan(values) | numpy.isnan(violations)
        if missing.all():
            return None
        violations[missing] = numpy.inf
        values[missing] = numpy.inf
        return int(numpy.lexsort((missing, values, violations))[0])

    def _guarded(self, function: Callable[..., None]) -> Callable[..., int]:
        """The function, as the library calls it: returns 0, 1 if there are no values, -1 to end the
        run."""

        def call(problem: int, x: int, *arrays: Optional[int]) -> int:
            if self.interrupted or self._raised is not None:
                return -1
            before = len(self.points)
            try:
                point = self._view(x, self.problem.dimension).copy()
                self._inside = True
                function(point, *arrays)
                return 0
            except Exception as error:
                try:
                    if len(self.points) == before:
                        self._row(point, numpy.nan, numpy.nan)
                    self.failure = self.failure or error
                    self._failed(f"{type(error).__name__}: {error}")
                except BaseException as warning:  # warnings may be errors
                    self._raised = warning
                    return -1
                return 1
            except BaseException as error:
                self.interrupted = isinstance(error, KeyboardInterrupt)
                self._raised = error
                return -1
            finally:
                self._inside = False

        return call

    def _values(self, x: _Vector, objective: Optional[int], constraints: Optional[int]) -> None:
        value = self._value_at(x)
        if objective:
            self._view(objective, 1)[0] = self.problem.sign * value
        if constraints:
            self._view(constraints, len(self._constraints))[:] = self._constraints

    def _derivatives(self, x: _Vector, *arrays: Optional[int]) -> None:
        objective, constraints, gradient, jacobian = arrays
        known = self._is_last(x)
        if objective:
            value = self.values[-1] if known else self._value_at(x)
            self._view(objective, 1)[0] = self.problem.sign * value
        if constraints:
            self._view(constraints, len(self._constraints))[:] = self._constraints
        if gradient and self.problem.jacobian:
            self._view(gradient, len(x))[:] = self._last_residuals @ self._jacobian_at(x)
        elif gradient:
            self._view(gradient, len(x))[:] = self.problem.sign * self.problem.gradient_at(x)
        if jacobian:
            rows = self.problem.constraint_jacobian(x)
            self._view(jacobian, rows.size)[:] = rows.ravel()

    def _residuals(self, x: _Vector, residuals: Optional[int], jacobian: Optional[int]) -> None:
        if not self._is_last(x):
            self._value_at(x)
        if residuals:
            self._view(residuals, len(self._last_residuals))[:] = self._last_residuals
        if jacobian:
            rows = self._jacobian_at(x)
            self._view(jacobian, rows.size)[:] = rows.ravel()

    def _jacobian_at(self, x: _Vector) -> _Vector:
        return shaped(
            "jacobian", self.problem.jacobian_at(x), (self.problem.residual_count(), len(x))
        )

    def _value_at(self, x: _Vector) -> float:
        problem, violation = self.problem, 0.0
        if problem.residuals is None:
            value = problem.value(x)
        else:
            self._last_residuals = problem.residuals_at(x)
            value = half_squares(self._last_residuals)
        if problem.constraints:
            self._constraints = problem.constraint_values(x)
            violation = problem.violation(self._constraints)
        self._row(x, value, violation)
        if value != value or violation != violation:
            self._failed("NaN")
        return value

    def _is_last(self, x: _Vector) -> bool:
        """Whether the last row has the values at x."""
        if self.problem.noise or not self.points:
            return False
        return self.values[-1] == self.values[-1] and numpy.array_equal(self.points[-1], x)

    def _row(self, x: _Vector, value: float, violation: float) -> None:
        self.points.append(x)
        self.values.append(value)
        self.violations.append(violation)
        self.seconds.append(time.perf_counter() - self._began)

    def _failed(self, message: str) -> None:
        self.failures[message] += 1
        if self.failures[message] == 1 and len(self.failures) <= _WARNED:
            warn(f"{self.problem.name} has no value at a point: {message}")

    def _view(self, address: int, size: int) -> _Vector:
        view = self._views.get(address)
        if view is None or len(view) != size:
            view = numpy.ctypeslib.as_array((ctypes.c_double * size).from_address(address))
            self._views[address] = view
        return view

    @contextlib.contextmanager
    def _interrupts(self) -> Iterator[None]:
        """Ctrl-C ends a function of the user's at once, and the solver at its next evaluation: an
        exception between the two would be lost in the library."""
        handler = signal.getsignal(signal.SIGINT)
        if (
            threading.current_thread() is not threading.main_thread()
            or handler is not signal.default_int_handler
        ):
            yield
            return

        def note(number: int, frame: Any) -> None:
            self.interrupted = True
            if self._inside:
                raise KeyboardInterrupt

        signal.signal(signal.SIGINT, note)
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, handler)
