#!/usr/bin/env python3
"""Differential evolution of SciPy, which calls back for every value: Debian's python3-scipy."""
import json
import math
import sys

import scipy
from scipy.optimize import differential_evolution


class Stop(Exception):
    """The evaluations are spent."""


def say(message):
    print(json.dumps(message), flush=True)


def objective(x):
    say({"ask": x.tolist()})
    answer = json.loads(sys.stdin.readline())
    if "stop" in answer:
        raise Stop
    value = answer["objective"]
    return math.inf if value is None else value


say({"name": "scipy-differential-evolution", "version": scipy.__version__, "stochastic": True})
for line in sys.stdin:
    problem = json.loads(line)
    try:
        found = differential_evolution(
            objective, list(zip(problem["lower"], problem["upper"])), x0=problem["start"],
            seed=problem["seed"], maxiter=10**6)
        say({"done": found.message, "point": found.x.tolist()})
    except Stop:
        say({"done": "stopped"})
