"""Solvers of SciPy for ricochet, each with the settings that SciPy gives it.

ricochet starts this program once, with a socket as standard input, through which it sends the end
of a connection whenever one of its processes begins to make runs. A copy of this program, which
has SciPy loaded, serves the connection by the line protocol of docs/own-solver.md, with one line
more before each problem: {"solver": NAME}. A copy whose connection is closed is killed, even in the
middle of compiled code.
"""

import gc
import json
import os
import select
import signal
import socket
import warnings

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # sums in one order

import numpy as np  # noqa: E402
import scipy  # noqa: E402
from scipy.optimize import NonlinearConstraint, differential_evolution, dual_annealing, minimize  # noqa: E402


class RunOver(BaseException):
    """The budget is spent. SciPy catches exceptions, but not this one."""


class NotFinite(BaseException):
    """A derivative is not finite: this start is at its end."""


class Problem:
    """A problem in the coordinates whose box has a width, for some solvers need one."""

    def __init__(self, told, ask):
        lower, upper, self.whole = (np.array(told[key], float) for key in ("lower", "upper", "start"))
        self.free = lower < upper
        self.bounds = list(zip(lower[self.free], upper[self.free]))
        self.start = self.whole[self.free]
        self.equalities, self.constrained = told["equalities"], told["constraints"]
        self.seed = told["seed"]
        self._ask = ask
        self._last, self._answer = None, {}

    def _at(self, x, key):
        """This entry of the answer for the point. One point in a row is asked for once."""
        if not np.array_equal(self._last, x) or key not in self._answer:
            self._answer = self._ask(self.inside(x), key in ("gradient", "jacobian"))
            self._last = np.array(x)
        return finite_or_worst(self._answer[key])

    def inside(self, x):
        """The point with all coordinates, as a list, with None where one is not finite."""
        whole = self.whole.copy()
        whole[self.free] = x
        return [number if np.isfinite(number) else None for number in whole.tolist()]

    def objective(self, x):
        return self._at(x, "objective").item()

    def _slopes(self, x, key):
        slopes = self._at(x, key)
        if not np.isfinite(slopes).all():
            raise NotFinite
        return slopes

    def gradient(self, x):
        return self._slopes(x, "gradient")[self.free]

    def constraints(self, x):
        """Equalities, which must be 0, first; the others must be <= 0."""
        return self._at(x, "constraints")

    def jacobian(self, x):
        return self._slopes(x, "jacobian")[:, self.free]


def finite_or_worst(numbers):
    """An array with infinity where the answer has null, for a number that is not finite."""
    array = np.array(numbers, float)
    return np.where(np.isnan(array), np.inf, array)


def slsqp(problem):
    first = problem.equalities
    constraints = []
    if first > 0:
        constraints.append({
            "type": "eq",
            "fun": lambda x: problem.constraints(x)[:first],
            "jac": lambda x: problem.jacobian(x)[:first],
        })
    if problem.constrained > first:
        constraints.append({
            "type": "ineq",
            "fun": lambda x: -problem.constraints(x)[first:],
            "jac": lambda x: -problem.jacobian(x)[first:],
        })
    return minimize(problem.objective, problem.start, jac=problem.gradient, method="SLSQP",
                    bounds=problem.bounds, constraints=constraints)


def l_bfgs_b(problem):
    return minimize(problem.objective, problem.start, jac=problem.gradient, method="L-BFGS-B",
                    bounds=problem.bounds)


def annealing(problem):
    return dual_annealing(problem.objective, problem.bounds, seed=problem.seed, x0=problem.start)


def evolution(problem):
    constraints = ()
    if problem.constrained > 0:
        least = np.full(problem.constrained, -np.inf)
        least[:problem.equalities] = 0
        constraints = NonlinearConstraint(problem.constraints, least, 0)
    return differential_evolution(problem.objective, problem.bounds, seed=problem.seed,
                                  x0=problem.start, constraints=constraints)


SOLVERS = {
    "scipy-slsqp": slsqp,
    "scipy-l-bfgs-b": l_bfgs_b,
    "scipy-dual-annealing": annealing,
    "scipy-differential-evolution": evolution,
}


def converse(lines):
    """Serves a connection, an open file for reading and writing, until its end."""

    def say(message):
        lines.write(json.dumps(message) + "\n")
        lines.flush()

    def hear():
        try:
            line = lines.readline()
        except ConnectionResetError:  # the other side ended before it read all
            line = ""
        if not line:
            os._exit(0)
        return json.loads(line)

    def ask(x, derivatives):
        say({"ask": x, "derivatives": derivatives})
        answer = hear()
        if "stop" in answer:
            raise RunOver
        return answer

    say({"name": "scipy", "version": scipy.__version__})
    while True:
        solver = SOLVERS[hear()["solver"]]
        problem = Problem(hear(), ask)
        try:
            result = solver(problem)
            message = result.message if isinstance(result.message, str) else "; ".join(result.message)
            say({"done": message, "point": problem.inside(result.x)})
        except RunOver:
            say({"done": "stopped"})
        except NotFinite:
            say({"done": "a number is not finite"})
        except Exception as error:  # SciPy refuses to go on
            say({"done": f"{type(error).__name__}: {error}"})


def serve(control):
    """Serves each connection that arrives by a copy of this process, until no more can arrive."""
    news = select.poll()
    news.register(control, select.POLLIN)
    copies = {}  # descriptor of the copy, and of its connection -> these two and the copy's number
    while True:
        for descriptor, _ in news.poll():
            if descriptor == control.fileno():
                _, arrived, _, _ = socket.recv_fds(control, 1, 1)
                if not arrived:
                    return
                child = os.fork()
                if child == 0:
                    for other in copies:
                        os.close(other)
                    control.close()
                    with socket.socket(fileno=arrived[0]) as connection:
                        converse(connection.makefile("rw", encoding="utf-8"))
                copy = (os.pidfd_open(child), arrived[0], child)
                copies[copy[0]] = copies[copy[1]] = copy
                news.register(copy[0], select.POLLIN)
                news.register(copy[1], select.POLLRDHUP)
            elif descriptor in copies:  # the copy is at its end, or nobody listens to it any more
                ended, connection, child = copies[descriptor]
                os.kill(child, signal.SIGKILL)
                os.waitpid(child, 0)
                for each in (ended, connection):
                    news.unregister(each)
                    os.close(each)
                    del copies[each]


def warm_up():
    """Runs every solver once, so that what SciPy loads and keeps is there before the first copy."""
    told = {"lower": [-1, -1], "upper": [2, 2], "start": [1, 1], "constraints": 1, "equalities": 0, "seed": 0}
    for solver in SOLVERS.values():
        left = iter(range(50))

        def ask(x, derivatives):
            if next(left, None) is None:
                raise RunOver
            return {"objective": x[0] ** 2 + x[1] ** 2, "constraints": [-1 - x[0]],
                    "gradient": [2 * x[0], 2 * x[1]], "jacobian": [[-1, 0]]}

        try:
            solver(Problem(told, ask))
        except RunOver:
            pass
    gc.freeze()  # a collection in a copy would write to all pages that it shares


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # a copy that nobody reads ends in silence
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    warm_up()
    with socket.socket(fileno=0) as control_socket:
        serve(control_socket)
