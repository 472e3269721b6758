"""What is told of a problem."""

from __future__ import annotations

from typing import NamedTuple

import numpy
from numpy.typing import NDArray

from ._library import Error


class RunOver(Error):
    """The budget is spent: nothing more is evaluated."""


class TrueValues(NamedTuple):
    """What the suite scores a point by, whatever the formulation."""

    objective: float
    violation: float  #: the largest of a constraint; 0 if feasible


class Variable(NamedTuple):
    """Name and unit of a variable; "" where it has none."""

    name: str
    unit: str


class Evaluated(NamedTuple):
    """The values at many points."""

    objectives: NDArray[numpy.float64]  #: of shape (points,)
    constraints: NDArray[numpy.float64]  #: of shape (points, constraints)
