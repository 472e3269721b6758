#!/usr/bin/env python3
"""COBYLA of NLopt, with constraints, through its own Python module: Debian's python3-nlopt."""
import json
import math
import sys

import nlopt


class Stop(Exception):
    """The evaluations are spent."""


def say(message):
    print(json.dumps(message), flush=True)


class Asked:
    """NLopt wants objective and constraints one after the other; one problem tells both."""

    def __init__(self):
        self.x, self.answer = None, None

    def at(self, x):
        if self.x != x.tolist():
            self.x = x.tolist()
            say({"ask": self.x})
            self.answer = json.loads(sys.stdin.readline())
        if "stop" in self.answer:
            raise Stop
        return self.answer


def number(value):
    return math.inf if value is None else value


def minimise(problem):
    asked, equalities = Asked(), problem["equalities"]
    solver = nlopt.opt(nlopt.LN_COBYLA, problem["dimension"])
    solver.set_lower_bounds(problem["lower"])
    solver.set_upper_bounds(problem["upper"])
    solver.set_min_objective(lambda x, gradient: number(asked.at(x)["objective"]))
    for k in range(problem["constraints"]):
        add = solver.add_equality_constraint if k < equalities else solver.add_inequality_constraint
        add(lambda x, gradient, k=k: number(asked.at(x)["constraints"][k]))
    solver.set_xtol_rel(1e-8)
    return solver.optimize(problem["start"]).tolist()


version = "%d.%d.%d" % (nlopt.version_major(), nlopt.version_minor(), nlopt.version_bugfix())
say({"name": "nlopt-cobyla-in-python", "version": version, "takes_constraints": 2})
for line in sys.stdin:
    try:
        say({"done": "tolerance reached", "point": minimise(json.loads(line))})
    except Stop:
        say({"done": "stopped"})
