"""The problems of ricochet, for optimisers in Python.

    import ricochet

    with ricochet.problem("count-C1") as q:
        print(q.lower, q.upper, q(q.start))

A problem is a minimisation problem within a box: an objective, and constraints of which the first
`equalities` must be 0 and the others <= 0, all to within 1e-6. What its variables are, and in which
units, is said by `ricochet evaluate NAME --describe`; constraints and objectives have the units that
`source` there names. Points outside the box are evaluated at their projection onto it.

The C library libricochet.so.3 is looked for where the environment variable RICOCHET_LIBRARY says,
else beside this file, else where the system keeps its libraries. Needs NumPy.
"""

import ctypes
import os
import pathlib
from typing import NamedTuple

import numpy

__all__ = ["Error", "RunOver", "TrueValues", "Problem", "problem", "problems"]

_ABI = 3
_UNLIMITED = 2**63 - 1


class Error(RuntimeError):
    """What went wrong, in the words of the library."""


class RunOver(Error):
    """The budget is spent: nothing more is evaluated."""


class TrueValues(NamedTuple):
    """What the suite judges a point by, whatever formulation was shown."""

    objective: float
    violation: float  #: the largest of a constraint; 0 where feasible


class _Problem(ctypes.Structure):
    """struct ricochet_problem of ricochet.h. A vector is the address of its first number."""


_vector = ctypes.c_void_p
_handle = ctypes.POINTER(_Problem)
_Problem._fields_ = [
    ("abi", ctypes.c_int32),
    ("dimension", ctypes.c_int32),
    ("constraints", ctypes.c_int32),
    ("equalities", ctypes.c_int32),
    ("has_derivatives", ctypes.c_int32),
    ("has_residuals", ctypes.c_int32),
    ("name", ctypes.c_char_p),
    ("lower", ctypes.POINTER(ctypes.c_double)),
    ("upper", ctypes.POINTER(ctypes.c_double)),
    ("start", ctypes.POINTER(ctypes.c_double)),
    ("values", ctypes.CFUNCTYPE(ctypes.c_int32, _handle, _vector, _vector, _vector)),
    (
        "derivatives",
        ctypes.CFUNCTYPE(ctypes.c_int32, _handle, _vector, _vector, _vector, _vector, _vector),
    ),
    ("residual_count", ctypes.CFUNCTYPE(ctypes.c_int32, _handle, _vector)),
    ("residuals", ctypes.CFUNCTYPE(ctypes.c_int32, _handle, _vector, _vector, _vector)),
    ("remaining", ctypes.CFUNCTYPE(ctypes.c_int64, _handle)),
    ("uniform", ctypes.CFUNCTYPE(ctypes.c_double, _handle)),
]


def _load():
    named = os.environ.get("RICOCHET_LIBRARY")
    beside = pathlib.Path(__file__).resolve().with_name("libricochet.so.3")
    path = named or (str(beside) if beside.exists() else "libricochet.so.3")
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(
            f"ricochet: {path} cannot be loaded ({error}); RICOCHET_LIBRARY may name another"
        ) from error
    library.ricochet_open.restype = _handle
    library.ricochet_open.argtypes = [
        ctypes.c_char_p, ctypes.c_char_p, ctypes.c_int32, ctypes.c_int64, ctypes.c_uint64,
    ]  # fmt: skip
    library.ricochet_open_scene.restype = _handle
    library.ricochet_open_scene.argtypes = [ctypes.c_char_p, *library.ricochet_open.argtypes]
    library.ricochet_close.restype = None
    library.ricochet_close.argtypes = [_handle]
    library.ricochet_judge.restype = ctypes.c_int32
    library.ricochet_judge.argtypes = [_handle, _vector, _vector, _vector]
    library.ricochet_problem_name.restype = ctypes.c_char_p
    library.ricochet_problem_name.argtypes = [ctypes.c_int32]
    library.ricochet_error.restype = ctypes.c_char_p
    library.ricochet_error.argtypes = []
    return library


_library = _load()


def _last_error():
    return _library.ricochet_error().decode(errors="replace")


def _array(numbers, size):
    """A copy, which nobody writes to, of so many numbers of the library's."""
    array = numpy.ctypeslib.as_array(numbers, (size,)).copy()
    array.flags.writeable = False
    return array


def _within(what, number, lowest, highest):
    if not lowest <= number <= highest:
        raise ValueError(f"{what} {number}: must be from {lowest} to {highest}")
    return number


def problems():
    """The names of all problems, as a list."""
    names = []
    while (name := _library.ricochet_problem_name(len(names))) is not None:
        names.append(name.decode())
    return names


def problem(name, formulation="", *, instance=0, budget=None, seed=0, scene=None):
    """Opens the problem of this name.

    formulation: how it is shown, such as "count", "surrogate" or "penalised-count"; "" as it is judged.
    instance: 0 as stated; 1, 2, ... the same problem in another box, moved and reflected.
    budget: evaluations, after which RunOver is raised; None for as many as you like.
    seed: of `uniform`, from 0 to 2**64 - 1.
    scene: a machine file, whose problem is meant, such as "profile-count-8-scene".

    Raises Error where there is no such problem or formulation, with what may have been meant, and
    where the machine file is not valid.
    """
    return Problem(name, formulation, instance=instance, budget=budget, seed=seed, scene=scene)


class Problem:
    """An open problem. One thread at a time may use it; `close` it, or use it in `with`.

    name: str.
    dimension, constraints, equalities: how many; the equalities are the first constraints.
    has_derivatives: whether `derivatives`, `gradient` and `jacobian` may be called.
    has_residuals: whether `residuals` and `residual_jacobian` may be called.
    lower, upper, start: arrays of shape (dimension,), in the units of the variables.

    The counting is that of the suite: a point costs 1 evaluation, with derivatives 1 + dimension;
    who asks for several things of one point, one after the other, pays for it once.
    """

    _problem = None  # until it is open, and after it was closed

    def __init__(self, name, formulation="", *, instance=0, budget=None, seed=0, scene=None):
        asked = (
            name.encode(),
            formulation.encode(),
            _within("instance", instance, 0, 2**31 - 1),
            _UNLIMITED if budget is None else _within("budget", budget, 1, _UNLIMITED),
            _within("seed", seed, 0, 2**64 - 1),
        )
        if scene is None:
            problem = _library.ricochet_open(*asked)
        else:
            problem = _library.ricochet_open_scene(os.fsencode(scene), *asked)
        if not problem:
            raise Error(_last_error())
        self._problem = problem
        shown = problem.contents
        if shown.abi != _ABI:
            self.close()
            raise ImportError(f"ricochet: the library's interface is {shown.abi}, not {_ABI}")
        self.name = shown.name.decode()
        self.dimension = shown.dimension
        self.constraints = shown.constraints
        self.equalities = shown.equalities
        self.has_derivatives = bool(shown.has_derivatives)
        self.has_residuals = bool(shown.has_residuals)
        self.lower = _array(shown.lower, shown.dimension)
        self.upper = _array(shown.upper, shown.dimension)
        self.start = _array(shown.start, shown.dimension)
        self._ask_values = shown.values
        self._ask_derivatives = shown.derivatives
        self._ask_residual_count = shown.residual_count
        self._ask_residuals = shown.residuals
        self._prepare()

    def _prepare(self):
        """Makes room for what goes in and comes out: addresses are slow to come by."""
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

    def _take(self, x):
        """Takes over a point. One that is not finite would end the run: it is refused here."""
        if self._problem is None:
            raise Error(f"{self.name} is closed")
        x = numpy.asarray(x, dtype=float)
        if x.shape != self._x.shape and not (x.ndim == 0 and self.dimension == 1):
            raise ValueError(f"x must be of shape {self._x.shape}, not {x.shape}")
        if not numpy.isfinite(x).all():
            raise ValueError(f"x must be finite, not {x}")
        self._x[...] = x

    def _values(self, x, at_objective, at_constraints):
        self._take(x)
        if self._ask_values(self._problem, self._at_x, at_objective, at_constraints):
            self._refused()

    def _derivatives(self, x, *addresses):
        if not self.has_derivatives:
            raise Error(f"{self.name} has no derivatives in this formulation")
        self._take(x)
        if self._ask_derivatives(self._problem, self._at_x, *addresses):
            self._refused()

    def _count_residuals(self, x):
        if not self.has_residuals:
            raise Error(f"{self.name} has no residuals in this formulation")
        self._take(x)
        count = self._ask_residual_count(self._problem, self._at_x)
        if not count:
            self._refused()
        return count

    def _refused(self):
        raise (RunOver if self.remaining == 0 else Error)(_last_error())

    def __call__(self, x):
        """The objective at x as a float, of a problem without constraints."""
        if self.constraints:
            raise TypeError(
                f"{self.name} has {self.constraints} constraints: ask for values(x), or for"
                " objective(x) and constraint_values(x)"
            )
        return self.objective(x)

    def objective(self, x):
        """The objective at x, of shape (dimension,), as a float."""
        self._values(x, self._at_objective, None)
        return self._told_objective.item()

    def constraint_values(self, x):
        """The constraints at x, of shape (constraints,): equalities first, the others <= 0."""
        self._values(x, None, self._at_constraints)
        return self._told_constraints.copy()

    def values(self, x):
        """Objective and constraints at x: a float, and an array of shape (constraints,)."""
        self._values(x, self._at_objective, self._at_constraints)
        return self._told_objective.item(), self._told_constraints.copy()

    def gradient(self, x):
        """The gradient of the objective at x, of shape (dimension,)."""
        self._derivatives(x, None, None, self._at_gradient, None)
        return self._told_gradient.copy()

    def jacobian(self, x):
        """The Jacobian of the constraints at x, of shape (constraints, dimension)."""
        self._derivatives(x, None, None, None, self._at_jacobian)
        return self._told_jacobian.copy()

    def derivatives(self, x):
        """Objective, constraints, gradient and Jacobian at x, as `values`, `gradient` and
        `jacobian` have them."""
        self._derivatives(
            x, self._at_objective, self._at_constraints, self._at_gradient, self._at_jacobian
        )
        return (
            self._told_objective.item(),
            self._told_constraints.copy(),
            self._told_gradient.copy(),
            self._told_jacobian.copy(),
        )

    def residuals(self, x):
        """The residuals at x, of whose squares the objective, or a smooth stand-in for it, is half
        the sum: of shape (residuals,). Costs 1 evaluation."""
        told = numpy.empty(self._count_residuals(x))
        if self._ask_residuals(self._problem, self._at_x, told.ctypes.data, None):
            self._refused()
        return told

    def residual_jacobian(self, x):
        """The Jacobian of the residuals at x, of shape (residuals, dimension). Costs 1 + dimension
        evaluations, or dimension where the residuals at x were just asked for."""
        told = numpy.empty((self._count_residuals(x), self.dimension))
        if self._ask_residuals(self._problem, self._at_x, None, told.ctypes.data):
            self._refused()
        return told

    def judge(self, x):
        """What the suite judges x by: a TrueValues. Costs no evaluation."""
        self._take(x)
        violation = ctypes.c_double()
        if _library.ricochet_judge(
            self._problem, self._at_x, self._at_objective, ctypes.byref(violation)
        ):
            raise Error(_last_error())
        return TrueValues(self._told_objective.item(), violation.value)

    def uniform(self):
        """A number uniform in [0, 1), from the seed."""
        if self._problem is None:
            raise Error(f"{self.name} is closed")
        return self._problem.contents.uniform(self._problem)

    @property
    def remaining(self):
        """Evaluations left."""
        if self._problem is None:
            raise Error(f"{self.name} is closed")
        return self._problem.contents.remaining(self._problem)

    def close(self):
        """Gives back what the problem holds; nothing may be asked afterwards."""
        problem, self._problem = self._problem, None
        if problem:
            _library.ricochet_close(problem)

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.close()

    def __del__(self):
        self.close()

    def __repr__(self):
        return f"<ricochet.Problem {self.name}{'' if self._problem else ', closed'}>"
