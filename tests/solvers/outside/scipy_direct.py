"""Calls SciPy as its users do and prints what it asks for: "value" or "gradient", and the point."""

import sys

import numpy as np
from scipy.optimize import NonlinearConstraint, differential_evolution, dual_annealing, minimize


def say(kind, x):
    print(kind, *(float(number).hex() for number in x))


def valley(x):
    say("value", x)
    a, b = x[0] * x[0] - x[1], 1 - x[0]
    return 100 * (a * a) + b * b


def valley_gradient(x):
    say("gradient", x)
    a, b = x[0] * x[0] - x[1], 1 - x[0]
    return np.array([400 * (a * x[0]) - 2 * b, -200 * a])


def lens(x):
    """Constraints: x + y = 1 and x^2 <= y."""
    return np.array([x[0] + x[1] - 1, x[0] * x[0] - x[1]])


def lens_jacobian(x):
    return np.array([[1, 1], [2 * x[0], -1]])


BOX = [(-2, 2), (-1, 3)]
START = [-1.25, 1]
EQUATION = {"type": "eq", "fun": lambda x: lens(x)[:1], "jac": lambda x: lens_jacobian(x)[:1]}
INEQUALITY = {"type": "ineq", "fun": lambda x: -lens(x)[1:], "jac": lambda x: -lens_jacobian(x)[1:]}

solver, constrained, seed = sys.argv[1], sys.argv[2] == "constrained", int(sys.argv[3])
if solver == "scipy-slsqp":
    found = minimize(valley, START, jac=valley_gradient, method="SLSQP", bounds=BOX,
                     constraints=[EQUATION, INEQUALITY] if constrained else [])
elif solver == "scipy-l-bfgs-b":
    found = minimize(valley, START, jac=valley_gradient, method="L-BFGS-B", bounds=BOX)
elif solver == "scipy-dual-annealing":
    found = dual_annealing(valley, BOX, x0=START, seed=seed, maxiter=20)
else:
    # A point that violates a constraint is not evaluated, and the first constraint is asked for it.
    constraint = NonlinearConstraint(lambda x: (say("constraints", x), lens(x))[1], [0, -np.inf], 0)
    found = differential_evolution(valley, BOX, x0=START, seed=seed, maxiter=5, polish=False,
                                   constraints=constraint if constrained else ())
say("returned", found.x)
