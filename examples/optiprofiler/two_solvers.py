"""Two solvers of SciPy on ricochet's problems, in OptiProfiler: python3 examples/optiprofiler/two_solvers.py"""

import pathlib

from optiprofiler import benchmark
from scipy.optimize import Bounds, minimize


def solver_of(method):
    def solve(fun, x0, xl, xu):
        return minimize(fun, x0, method=method, bounds=Bounds(xl, xu)).x

    return solve


if __name__ == "__main__":
    scores, *_ = benchmark(
        [solver_of("Nelder-Mead"), solver_of("Powell")], solver_names=["Nelder-Mead", "Powell"],
        ptype="b", mindim=1, maxdim=2, problem_names=["count-C1", "count-C4", "profile-count-2-C4"],
        plibs=["ricochet"], custom_problem_libs_path=str(pathlib.Path(__file__).parent),
        max_eval_factor=50, n_jobs=1, draw_hist_plots="none",
    )  # fmt: skip
    print(scores)
