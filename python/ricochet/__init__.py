"""ricochet from Python: its problems for optimisers, and its machine.

A problem is a minimisation problem within a box: an objective, and constraints of which the first
`equalities` must be 0 and the others <= 0, all to within 1e-6.

>>> import ricochet
>>> with ricochet.problem("count-C1") as problem:
...     print(problem.variables, problem.lower, problem.upper, problem(problem.start))
(Variable(name='speed', unit='rad/s'),) [0.01] [18.] 8.0

A machine is one yarn carrier in its clearance, described by a TOML file.

>>> scene = ricochet.Scene.load("machine.toml")
>>> scene.counts([5.0, 6.0, 7.0])
array([ 0, 21, 42], dtype=int32)

A function of your own is minimised by the solvers of the suite, in this process.

>>> bowl = ricochet.Problem(lambda x: (x[0] - 1) ** 2 + x[1] ** 2, [-2, -2], [2, 2])
>>> found = ricochet.minimise(bowl, budget=200)
>>> print(found.solver, found.x.round(4) + 0, round(found.value, 6))
nlopt-mlsl-bobyqa [1. 0.] 0.0

`ricochet.runs` reads a store of runs, `ricochet.solver` makes a function a solver that ricochet
compares with others.

The C library libricochet.so.3 is loaded at its first use: the one that the environment variable
RICOCHET_LIBRARY names, else the one beside these files, else the system's. Needs NumPy.
libricochet_minimise.so.3, with the solvers, lies beside it.
"""

from ._library import Error
from ._minimise import Result, compare, minimise
from ._own_problem import Problem
from ._problem import SuiteProblem, problem, problems
from ._results import Evaluated, RunOver, TrueValues, Variable
from ._scene import Impacts, Path, Regime, Scene, Simulation, Threshold
from ._solver import SearchedProblem, solver
from ._store import runs

__version__ = "0.2.0"

__all__ = [
    "Error",
    "Evaluated",
    "Impacts",
    "Path",
    "Problem",
    "Regime",
    "Result",
    "RunOver",
    "Scene",
    "SearchedProblem",
    "Simulation",
    "SuiteProblem",
    "Threshold",
    "TrueValues",
    "Variable",
    "compare",
    "minimise",
    "problem",
    "problems",
    "runs",
    "solver",
]

for _name in __all__:  # errors and help name them as users do
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
