"""The calls of the library that ask an open problem."""

from __future__ import annotations

import ctypes
import threading
from typing import NoReturn, Optional

import numpy
from numpy.typing import ArrayLike, NDArray

from ._library import Error, last_error, library
from ._results import Evaluated, RunOver, TrueValues

_Vector = NDArray[numpy.float64]


class Room(threading.local):
    """Each thread's own room for a point and its results: addresses are slow to come by."""

    def __init__(self, dimension: int, constraints: int) -> None:
        self.x = numpy.empty(dimension)
        self.objective = numpy.empty(1)
        self.constraints = numpy.empty(constraints)
        self.gradient = numpy.empty(dimension)
        self.jacobian = numpy.empty((constraints, dimension))
        self.at_x = self.x.ctypes.data
        self.at_objective = self.objective.ctypes.data
        self.at_constraints = self.constraints.ctypes.data
        self.at_gradient = self.gradient.ctypes.data
        self.at_jacobian = self.jacobian.ctypes.data


class Calls:
    """An open problem, which is closed at the latest with this. Several threads may call it at
    once."""

    def __init__(self, opened: int) -> None:
        ask = library()
        self.opened: Optional[int] = opened
        self.name: str = ask.ricochet_name(opened).decode()
        self.dimension: int = ask.ricochet_dimension(opened)
        self.constraint_count: int = ask.ricochet_constraints(opened)
        self.has_derivatives = bool(ask.ricochet_has_derivatives(opened))
        self.has_residuals = bool(ask.ricochet_has_residuals(opened))
        self._ask_values = ask.ricochet_values
        self._ask_derivatives = ask.ricochet_derivatives
        self.room = Room(self.dimension, self.constraint_count)

    def handle(self) -> int:
        """Of the open problem. Raises Error if it was closed."""
        if self.opened is None:
            raise Error(f"{self.name} is closed")
        return self.opened

    def values(
        self, x: ArrayLike, room: Room, at_objective: Optional[int], at_constraints: Optional[int]
    ) -> None:
        if self._ask_values(self._take(x, room), room.at_x, at_objective, at_constraints):
            self._refused()

    def derivatives(self, x: ArrayLike, room: Room, *addresses: Optional[int]) -> None:
        if not self.has_derivatives:
            raise Error(f"{self.name} has no derivatives in this formulation")
        if self._ask_derivatives(self._take(x, room), room.at_x, *addresses):
            self._refused()

    def batch(self, points: ArrayLike) -> Evaluated:
        opened = self.handle()
        many = numpy.ascontiguousarray(points, dtype=float)
        if many.ndim != 2 or many.shape[1] != self.dimension:
            raise ValueError(f"points must be of shape (n, {self.dimension}), not {many.shape}")
        if not numpy.isfinite(many).all():
            raise ValueError("points must be finite")
        if len(many) > self.remaining():
            raise RunOver(f"{len(many)} points, but {self.remaining()} evaluations are left")
        told = Evaluated(numpy.empty(len(many)), numpy.empty((len(many), self.constraint_count)))
        if library().ricochet_values_batch(
            opened, many.ctypes.data, len(many), *(each.ctypes.data for each in told)
        ) < len(many):
            self._refused()
        return told

    def residual_count(self, x: ArrayLike) -> int:
        """How many residuals there are at x, which `residuals` then tells."""
        if not self.has_residuals:
            raise Error(f"{self.name} has no residuals in this formulation")
        room = self.room
        count: int = library().ricochet_residual_count(self._take(x, room), room.at_x)
        if not count:
            self._refused()
        return count

    def residuals(self, told: _Vector, *addresses: Optional[int]) -> _Vector:
        if library().ricochet_residuals(self.handle(), self.room.at_x, *addresses):
            self._refused()
        return told

    def judge(self, x: ArrayLike) -> TrueValues:
        room = self.room
        objective, violation = ctypes.c_double(), ctypes.c_double()
        if library().ricochet_judge(
            self._take(x, room), room.at_x, ctypes.byref(objective), ctypes.byref(violation)
        ):
            raise Error(last_error())
        return TrueValues(objective.value, violation.value)

    def remaining(self) -> int:
        left: int = library().ricochet_remaining(self.handle())
        return left

    def close(self) -> None:
        opened, self.opened = self.opened, None
        if opened:
            library().ricochet_close(opened)

    def __del__(self) -> None:
        self.close()

    def _take(self, x: ArrayLike, room: Room) -> int:
        """Takes over a point. One that is not finite would end the run: it is refused here."""
        opened = self.handle()
        x = numpy.asarray(x, dtype=float)
        if x.shape != room.x.shape and not (x.ndim == 0 and self.dimension == 1):
            raise ValueError(f"x must be of shape {room.x.shape}, not {x.shape}")
        if not numpy.isfinite(x).all():
            raise ValueError(f"x must be finite, not {x}")
        room.x[...] = x
        return opened

    def _refused(self) -> NoReturn:
        raise (RunOver if self.remaining() == 0 else Error)(last_error())
