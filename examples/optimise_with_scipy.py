#!/usr/bin/env python3
"""Differential evolution of SciPy on one problem of ricochet, called from Python."""
import ricochet
from scipy.optimize import differential_evolution

with ricochet.problem("count-C4", budget=5000) as problem:
    best = differential_evolution(problem, list(zip(problem.lower, problem.upper)), maxiter=50, seed=1)
    print(f"{problem.judge(best.x).objective:g} collisions at {best.x[0]:.2f} rad/s")
