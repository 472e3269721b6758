#!/usr/bin/env python3
"""Powell's method of SciPy as a solver of ricochet: a function, without the line protocol."""
import ricochet
import scipy
from scipy.optimize import Bounds, minimize


def powell(problem):
    return minimize(
        problem, problem.start, method="Powell", bounds=Bounds(problem.lower, problem.upper)
    )


ricochet.solver(powell, name="powell", version=scipy.__version__)
