"""ricochet's problems as a problem library of OptiProfiler.

    from optiprofiler import benchmark
    benchmark([solver1, solver2], ptype="bn", plibs=["ricochet"],
              custom_problem_libs_path="examples/optiprofiler")

Names are those of `ricochet.problems()`; a formulation or an instance follows after a colon, as in
"profile-count-8-C4:surrogate" or "count-C1:count:2". OptiProfiler asks for these two functions; see
problem_libs/README.txt of OptiProfiler. All problems have a box of finite bounds, and no linear
constraints, so their types are b and n.
"""

import math

import ricochet
from optiprofiler.opclasses import Problem


def _opened(name):
    """The problem of a name with its formulation and instance."""
    name, formulation, instance = (name.split(":") + ["", ""])[:3]
    return ricochet.problem(name, formulation, instance=int(instance or 0))


def ricochet_load(problem_name):
    """The problem, which stays open as long as OptiProfiler holds it."""
    q = _opened(problem_name)
    constraints = {}
    if q.constraints > q.equalities:
        constraints["cub"] = lambda x: q.constraint_values(x)[q.equalities :]
    if q.equalities:
        constraints["ceq"] = lambda x: q.constraint_values(x)[: q.equalities]
    return Problem(q.objective, q.start, problem_name, q.lower, q.upper, **constraints)


def ricochet_select(options):
    """The names of all problems in their original formulation that have what the options ask for."""
    names = []
    for name in ricochet.problems():
        with ricochet.problem(name) as q:
            traits = {
                "dim": q.dimension, "b": 2 * q.dimension, "lcon": 0, "nlcon": q.constraints, "con": q.constraints
            }  # fmt: skip
        fits = all(
            options.get("min" + key, 0) <= value <= options.get("max" + key, math.inf)
            for key, value in traits.items()
        )
        kind = "n" if traits["nlcon"] else "b"
        if fits and kind in options.get("ptype", "ubln") and name not in options.get("excludelist", []):
            names.append(name)
    return names
