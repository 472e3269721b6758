"""ricochet's problems in IOHexperimenter: python3 examples/ioh_style.py results

Needs the package ioh. Written against its documented interface (0.3.22): `ioh.wrap_problem` and the
logger `ioh.logger.Analyzer`, whose folder IOHanalyzer opens. ioh has one bound for all variables, so
the box of a problem is the unit cube there; constraints become the penalty of a penalised formulation.
"""

import sys

import ioh
import numpy
import ricochet


def wrapped(name, formulation="", instance=0):
    """A problem of ricochet as one of ioh's, on the unit cube."""
    q = ricochet.problem(name, formulation, instance=instance)
    if q.constraints:
        raise ValueError(f"{name}: choose a penalised formulation, such as penalised-count")

    def objective(u):
        return q.objective(q.lower + numpy.asarray(u) * (q.upper - q.lower))

    return ioh.wrap_problem(
        objective, name=name, problem_class=ioh.ProblemClass.REAL, dimension=q.dimension, instance=instance,
        optimization_type=ioh.OptimizationType.MIN, lb=0, ub=1,
    )  # fmt: skip


if __name__ == "__main__":
    logger = ioh.logger.Analyzer(root=sys.argv[1], folder_name="ricochet", algorithm_name="random search")
    for name, formulation in [("count-C1", ""), ("top-speed-C1", "penalised-count")]:
        problem = wrapped(name, formulation, instance=1)
        problem.attach_logger(logger)
        draw = numpy.random.default_rng(1)
        while problem.state.evaluations < 50 * problem.meta_data.n_variables:
            problem(draw.uniform(size=problem.meta_data.n_variables))
        print(f"{name}: {problem.state.current_best.y:g}")
        problem.reset()
