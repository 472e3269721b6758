"""A machine: its collisions, its motion, its regimes and its fastest quiet speed."""

from __future__ import annotations

import ctypes
import dataclasses
import math
import os
import threading
from typing import Any, List, NamedTuple, Optional, Tuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._library import Error, last_error, library

_TYPES = {"d": numpy.float64, "i": numpy.int32}


class Impacts(NamedTuple):
    """All impacts of a simulation, counted or not, as arrays of shape (impacts,)."""

    times: NDArray[numpy.float64]  #: [s]
    speeds: NDArray[numpy.float64]  #: [m/s], of approach
    walls: NDArray[numpy.int32]  #: 0 lower, 1 upper


class Path(NamedTuple):
    """Samples of the motion, as arrays of shape (samples,)."""

    times: NDArray[numpy.float64]  #: [s]
    positions: NDArray[numpy.float64]  #: [m]
    velocities: NDArray[numpy.float64]  #: [m/s]


@dataclasses.dataclass(frozen=True)
class Simulation:
    """The results of one simulation."""

    count: int  #: of collisions
    certain: bool  #: whether small changes of the machine leave the count as it is
    doubt: str  #: why it is not certain; "" if it is
    impacts: Impacts
    path: Path
    reached: Optional[float] = None  #: [s], if the time limit ended it there; then not certain


class Regime(NamedTuple):
    """A range of speeds in which the motion of the long run stays of one kind."""

    lowest: float  #: [rad/s]
    highest: float  #: [rad/s]
    mean_per_turn: float  #: collisions in a turn of the driver plate
    least_per_turn: float
    most_per_turn: float
    turns: int  #: of one period; 0 if the motion does not repeat
    rests: bool  #: whether the carrier comes to rest in every period
    certain: bool
    #: What ends it at its fast end, such as "counting-limit"; "time-limit": the last one that is
    #: known.
    ends_by: str


class _Threshold(NamedTuple):
    quiet: Optional[float]  #: [rad/s], the fastest quiet speed
    first_loud: Optional[float]  #: [rad/s]
    limit: Optional[float]  #: of the measure; up to it a speed is quiet


class Threshold(_Threshold):
    """The fastest quiet speed of a machine. None where there is none.

    If no speed is quiet, not even the slowest, quiet is None and first_loud the slowest.
    """

    reached: Optional[float] = None  #: [rad/s], if the time limit ended the search there


class Scene:
    """A machine: one yarn carrier in its clearance, from `Scene.load` or `Scene.parse`.

    Several threads may use it at once. It can be pickled. A call that takes longer than its
    seconds, 60 by default, returns what it knows by then, and says so; math.inf: no limit.

    >>> scene = ricochet.Scene.load("machine.toml")
    >>> scene.simulate(7.0).count
    42
    >>> scene.threshold().quiet
    6.311
    """

    _machine: Optional[int] = None  # until it is open

    def __init__(self, machine: Optional[int]) -> None:
        if not machine:
            raise Error(last_error())
        self._machine = machine
        self._lock = threading.Lock()  # the library keeps the results of one call

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Scene:
        """The machine in a TOML file; docs/machine-files.md says what that holds.

        Raises Error, with file, key, value and what is allowed, if it is not valid.

        >>> ricochet.Scene.load("machine.toml").omega
        1.0
        >>> ricochet.Scene.load("none.toml")
        Traceback (most recent call last):
        ricochet.Error: none.toml: there is no such file
        """
        return cls(library().ricochet_open_machine(os.fsencode(path)))

    @classmethod
    def parse(cls, text: str) -> Scene:
        """The machine in the text of such a file. Errors call it "text".

        >>> text = ricochet.Scene.load("machine.toml").text
        >>> ricochet.Scene.parse(text.replace("friction = 0.2", "friction = -0.2"))
        Traceback (most recent call last):
        ricochet.Error: text: scene.friction = -0.2: must be a finite number >= 0 [1], at most 1e15
        """
        return cls(library().ricochet_parse_machine(text.encode()))

    @property
    def text(self) -> str:
        """The text of its file.

        >>> print(ricochet.Scene.load("machine.toml").text.splitlines()[1])
        [scene]
        """
        text: bytes = library().ricochet_machine_text(self._machine)
        return text.decode()

    @property
    def omega(self) -> Optional[float]:
        """The speed of the driver plate in the file [rad/s]; None if that is a profile."""
        omega: float = library().ricochet_machine_speed(self._machine)
        return None if math.isnan(omega) else omega

    def counts(self, omegas: ArrayLike, seconds: float = 60.0) -> NDArray[numpy.int32]:
        """The collision counts at speeds [rad/s], in an array of their shape.

        One simulation each; if neighbours are similar, several run side by side. Raises Error if
        they take longer than `seconds`.

        >>> scene = ricochet.Scene.load("machine.toml")
        >>> scene.counts(numpy.linspace(5.0, 7.0, 5))
        array([ 0,  0, 21, 42, 42], dtype=int32)
        """
        speeds = numpy.array(omegas, dtype=float, order="C")
        counts = numpy.empty(speeds.shape, numpy.int32)
        _limit(seconds)
        if library().ricochet_counts(
            self._machine, speeds.ctypes.data, speeds.size, counts.ctypes.data
        ):
            raise Error(last_error())
        return counts

    def simulate(
        self, omega: Optional[float] = None, samples: int = 0, seconds: float = 60.0
    ) -> Simulation:
        """One simulation at a speed [rad/s], or at the speed, or profile, of the file.

        samples: of the path, about so many, from 0 (no path) to 10,000,000. Costs as much as
        five counts: the others say whether the count is certain. If it takes longer than
        `seconds`, everything is that of the time up to `reached`.

        >>> found = ricochet.Scene.load("machine.toml").simulate(7.0, samples=1000)
        >>> found.count, found.certain, len(found.impacts.times), len(found.path.times)
        (42, True, 273, 1938)
        >>> float(found.impacts.speeds.max().round(4))
        0.0432
        """
        ask, count, certain = library(), ctypes.c_int32(), ctypes.c_int32()
        speed = math.nan if omega is None else _finite("omega", omega)
        _limit(seconds)
        with self._lock:
            if ask.ricochet_simulate(
                self._machine, speed, samples, ctypes.byref(count), ctypes.byref(certain)
            ):
                raise Error(last_error())
            impacts = self._columns(ask.ricochet_impacts, "ddi")
            path = self._columns(ask.ricochet_path, "ddd")
            doubt: bytes = ask.ricochet_doubt(self._machine)
        return Simulation(
            count.value,
            bool(certain.value),
            doubt.decode(),
            Impacts(*impacts),
            Path(*path),
            _or_none(ask.ricochet_reached()),
        )

    def regimes(
        self, lowest: float = 0.01, highest: float = 18.0, seconds: float = 60.0
    ) -> List[Regime]:
        """What the machine does in the long run over the speeds [rad/s], by increasing speed.

        If it takes longer than `seconds`, the last regime ends by "time-limit", before `highest`,
        and is not certain.

        >>> for regime in ricochet.Scene.load("machine.toml").regimes()[:3]:
        ...     print(f"to {regime.highest:.3f}: {regime.most_per_turn:g} ({regime.ends_by})")
        to 5.501: 0 (release)
        to 5.654: 0 (counting-limit)
        to 6.312: 2 (counting-limit)
        """
        ask = library()
        _limit(seconds)
        with self._lock:
            if ask.ricochet_regimes(self._machine, lowest, highest) < 0:
                raise Error(last_error())
            columns = self._columns(ask.ricochet_regime_table, "dddddiii")
            ends = [
                ask.ricochet_regime_end(self._machine, k).decode() for k in range(len(columns[0]))
            ]
        columns = (*columns[:6], *(column.astype(bool) for column in columns[6:]))
        return [Regime(*row) for row in zip(*(column.tolist() for column in columns), ends)]

    def threshold(
        self,
        measure: Optional[str] = None,
        at_most: Optional[float] = None,
        fastest: float = 18.0,
        seconds: float = 60.0,
    ) -> Threshold:
        """The fastest quiet speed up to `fastest` [rad/s], as `ricochet threshold` finds it.

        measure: what must be `at_most`: "collisions" in the window, "collisions-per-turn" in the
        long run, "energy" [J] in the window, "impact-speed" [m/s]; None for two collisions per
        turn or, of a machine without regimes, for the level below the largest step of its counts.
        Takes up to some seconds. If it takes longer than `seconds`, `reached` says up to which
        speed is known what is said.

        >>> scene = ricochet.Scene.load("machine.toml")
        >>> scene.threshold("collisions", 10)
        Threshold(quiet=5.654, first_loud=5.655, limit=10.0)
        """
        if (measure is None) != (at_most is None):
            raise ValueError("measure and at_most: give both or neither")
        found = [ctypes.c_double() for _ in Threshold._fields]
        _limit(seconds)
        if library().ricochet_quiet_speed(
            self._machine,
            None if measure is None else measure.encode(),
            math.nan if at_most is None else at_most,
            _finite("fastest", fastest),
            *map(ctypes.byref, found),
        ):
            raise Error(last_error())
        threshold = Threshold(*(_or_none(each.value) for each in found))
        threshold.reached = _or_none(library().ricochet_reached())
        return threshold

    def _columns(self, function: Any, kinds: str) -> Tuple[NDArray[Any], ...]:
        """What a function writes into one array for each kind: d is double, i is int32."""
        size = function(self._machine, *[None] * len(kinds))
        columns = tuple(numpy.empty(size, _TYPES[kind]) for kind in kinds)
        function(self._machine, *(column.ctypes.data for column in columns))
        return columns

    def __reduce__(self) -> Tuple[Any, ...]:
        return Scene.parse, (self.text,)

    def __del__(self) -> None:
        machine, self._machine = self._machine, None
        if machine:
            library().ricochet_close_machine(machine)

    def __repr__(self) -> str:
        return f"<ricochet.Scene at {self.omega} rad/s>"


def _limit(seconds: float) -> None:
    """Limits the calls of this thread."""
    if library().ricochet_limit_seconds(seconds):
        raise Error(last_error())


def _or_none(number: float) -> Optional[float]:
    return None if math.isnan(number) else number


def _finite(what: str, number: float) -> float:
    if not math.isfinite(number):
        raise ValueError(f"{what} {number}: must be finite")
    return number
