"""Functions in Python, minimised by the solvers of the suite: closed forms, failures, traces."""

import os
import signal
import subprocess
import sys
import threading
import unittest
import warnings

try:
    import numpy
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

try:
    import pandas
except ImportError:
    pandas = None

import ricochet

needs_pandas = unittest.skipUnless(pandas, "this Python has no pandas (Debian: python3-pandas)")


def bowl(x):
    """Least at (1, -2)."""
    return (x[0] - 1) ** 2 + (x[1] + 2) ** 2


BOX = [-5, -5], [5, 5]


class Finds(unittest.TestCase):
    def test_the_best_point_of_a_box(self):
        found = ricochet.minimise(ricochet.Problem(bowl, *BOX, start=[4, 4]))
        self.assertLess(abs(found.x - [1, -2]).max(), 1e-6)
        self.assertEqual(found.value, bowl(found.x))
        self.assertEqual((found.violation, found.evaluations, found.failed), (0, 500, 0))
        self.assertEqual(found.solver, "nlopt-mlsl-bobyqa")
        self.assertIn("quadratic models", found.why)
        self.assertIn("budget is spent", found.ended)
        self.assertEqual(ricochet.minimise(ricochet.Problem(bowl, *BOX), "nlopt-cobyla").why, "")

    def test_the_largest_value_of_what_is_to_be_large(self):
        top = ricochet.Problem(lambda x: 3 - bowl(x), *BOX, maximise=True)
        self.assertAlmostEqual(ricochet.minimise(top).value, 3, 9)

    def test_the_best_point_within_constraints_of_every_sense(self):
        # x + y with x y = 2 and x <= 1 is least at (1, 2).
        product = (lambda x: x[0] * x[1] - 2, "== 0", lambda x: [x[1], x[0]])
        for bound in [
            (lambda x: x[0] - 1, "<= 0", lambda x: [1, 0]),
            (lambda x: 1 - x[0], ">=0", lambda x: [-1, 0]),
        ]:
            for gradient in (None, lambda x: [1, 1]):
                # Equalities are first in the library, whatever the order here.
                problem = ricochet.Problem(
                    sum, [0.1, 0.1], [5, 5], constraints=[bound, product], gradient=gradient
                )
                found = ricochet.minimise(problem)
                self.assertEqual(found.violation, 0)
                self.assertAlmostEqual(found.value, 3, 5)
                self.assertEqual("derivatives" in found.why, "no derivatives" in found.why or bool(gradient))
        plain = ricochet.Problem(sum, [0.1, 0.1], [5, 5], constraints=[lambda x: 2 - x[0] * x[1]])
        self.assertAlmostEqual(ricochet.minimise(plain).value, 2 * 2**0.5, 5)
        penalised = ricochet.minimise(plain, "nlopt-bobyqa")
        self.assertEqual(penalised.violation, 0)
        self.assertLess(penalised.value, 3)

    def test_residuals_that_vanish(self):
        def valley(x):
            return [10 * (x[1] - x[0] ** 2), 1 - x[0]]

        for jacobian in (None, lambda x: [[-20 * x[0], 10], [-1, 0]]):
            problem = ricochet.Problem(
                None, [-2, -2], [2, 2], start=[-1.2, 1], residuals=valley, jacobian=jacobian
            )
            for solver in ("auto", "ceres-trust-region", "nlopt-bobyqa"):
                with self.subTest(solver=solver, jacobian=bool(jacobian)):
                    found = ricochet.minimise(problem, solver, 300)
                    self.assertLess(abs(found.x - 1).max(), 1e-4)
                    self.assertAlmostEqual(found.value, 0, 8)

    def test_by_a_gradient_with_fewer_calls(self):
        calls = []

        def counted(x):
            calls.append(x)
            return bowl(x)

        problem = ricochet.Problem(
            counted, *BOX, start=[4, 4], gradient=lambda x: [2 * (x[0] - 1), 2 * (x[1] + 2)]
        )
        found = ricochet.minimise(problem, "nlopt-lbfgs", 30)
        self.assertAlmostEqual(found.value, 0, 9)
        self.assertLess(len(calls), found.evaluations)

    def test_the_best_of_values_that_jump(self):
        problem = ricochet.Problem(lambda x: numpy.floor(abs(x)).sum(), *BOX, start=[4, 4], jumps=True)
        found = ricochet.minimise(problem)
        self.assertEqual(found.value, 0)
        self.assertIn("jump", found.why)

    def test_the_mean_of_noise(self):
        draw = numpy.random.default_rng(1)
        problem = ricochet.Problem(lambda x: bowl(x) + draw.normal(), *BOX, noise=True)
        found = ricochet.minimise(problem, "nlopt-bobyqa", 200)
        self.assertLess(found.value, found.mean, "the best is best by luck")
        self.assertLess(abs(found.mean - bowl(found.x)), 4 * found.standard_error)
        self.assertIsNone(ricochet.minimise(ricochet.Problem(bowl, *BOX)).mean)


class Runs(unittest.TestCase):
    @needs_pandas
    def test_have_the_values_of_the_function_to_the_bit(self):
        called = []

        def f(x):
            called.append((x.copy(), bowl(x)))
            x[:] = 99  # its own copy
            return called[-1][1]

        for solver in ("auto", "nlopt-cobyla", "pagmo-de", "random-search", "mads-tuned"):
            with self.subTest(solver=solver):
                called.clear()
                found = ricochet.minimise(ricochet.Problem(f, *BOX), solver, 200)
                trace = found.trace
                self.assertEqual(list(trace), ["value", "violation", "best", "seconds", "x1", "x2"])
                self.assertEqual(trace["value"].tolist(), [value for _, value in called])
                self.assertEqual(trace[["x1", "x2"]].values.tolist(), [x.tolist() for x, _ in called])
                self.assertEqual(trace["best"].iloc[-1], found.value)
                self.assertEqual(trace["value"].min(), found.value)
                self.assertTrue(trace["seconds"].is_monotonic_increasing)
                self.assertEqual(len(trace), found.evaluations)

    def test_are_the_same_for_the_same_seed(self):
        problem = ricochet.Problem(bowl, *BOX)
        for solver in ("nlopt-cobyla", "pagmo-cmaes", "bbfwa"):
            with self.subTest(solver=solver):
                first, again, other = (
                    ricochet.minimise(problem, solver, 300, seed=seed)._run for seed in (5, 5, 6)
                )
                self.assertEqual(first.values, again.values)
                self.assertNotEqual(first.values, other.values)
                self.assertEqual(first.values[0], other.values[0])

    def test_go_on_after_failures_and_count_them(self):
        raised = [0]

        def f(x):
            if x[0] > 5 / 3:  # a third of the box
                raised[0] += 1
                raise ValueError("too far")
            return bowl(x) if x[1] < 4.9 else numpy.nan

        for solver in ("auto", "random-search", "nlopt-cobyla", "pagmo-de"):
            with self.subTest(solver=solver), self.assertWarnsRegex(RuntimeWarning, "too far"):
                raised[0] = 0
                found = ricochet.minimise(ricochet.Problem(f, *BOX, start=[4, 4]), solver)
            self.assertEqual(found.failures["ValueError: too far"], raised[0])
            self.assertEqual(found.failed, sum(found.failures.values()))
            self.assertEqual(len(found._run.values), found.evaluations)
            self.assertGreater(raised[0], 0)
            self.assertLess(found.value, 4.1)

    def test_without_a_value_say_why(self):
        problem = ricochet.Problem(lambda x: missing, *BOX)  # noqa: F821
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with self.assertRaisesRegex(ricochet.Error, "no evaluation .* has a value: NameError") as at:
                ricochet.minimise(problem)
        self.assertIsInstance(at.exception.__cause__, NameError)

    def test_end_with_what_is_no_failure(self):
        def f(x):
            raise SystemExit(3)

        with self.assertRaises(SystemExit):
            ricochet.minimise(ricochet.Problem(f, *BOX))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(RuntimeWarning, "NaN"):
                ricochet.minimise(ricochet.Problem(lambda x: numpy.nan, *BOX))

    def test_return_the_best_so_far_if_interrupted(self):
        calls = [0]

        def f(x):
            calls[0] += 1
            if calls[0] == 20:
                os.kill(os.getpid(), signal.SIGINT)
            return bowl(x)

        with self.assertWarnsRegex(RuntimeWarning, "interrupted"):
            found = ricochet.minimise(ricochet.Problem(f, *BOX), "nlopt-cobyla")
        self.assertEqual(found.ended, "interrupted")
        self.assertEqual(calls[0], 20)
        self.assertEqual(found.value, min(found._run.values))
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)

    def test_end_at_the_next_call_if_interrupted_in_between(self):
        run = ricochet._run.Run(ricochet.Problem(bowl, *BOX))
        run.interrupted = True
        run.solve("nlopt-cobyla", run.problem.start, 100, 0)
        self.assertEqual((run.points, run.ended), ([], "interrupted"))

    def test_do_not_call_the_function_again_for_a_gradient(self):
        again = [0]
        for solver in ("nlopt-lbfgs", "nlopt-slsqp", "ceres-lbfgs", "ipopt"):
            problem = ricochet.Problem(
                bowl, *BOX, gradient=lambda x: [2 * (x[0] - 1), 2 * (x[1] + 2)]
            )
            try:
                points = ricochet.minimise(problem, solver, 100)._run.points
            except ricochet.Error as error:
                self.assertIn("this build has no", str(error))
                continue
            again[0] += sum(numpy.array_equal(a, b) for a, b in zip(points, points[1:]))
        self.assertEqual(again[0], 0)

    def test_of_several_threads_keep_apart(self):
        found = {}

        def search(seed):
            problem = ricochet.Problem(bowl, *BOX)
            found[seed] = ricochet.minimise(problem, "pagmo-de", 500, seed=seed)._run.values

        threads = [threading.Thread(target=search, args=(seed,)) for seed in range(4)]
        for each in threads:
            each.start()
        for each in threads:
            each.join()
        together = dict(found)
        for seed in range(4):
            search(seed)
        self.assertEqual(found, together)

    def test_may_be_by_solvers_of_other_processes_and_libraries(self):
        code = (
            "import ricochet, subprocess\n"
            "before = subprocess.run('env', capture_output=True).stdout.splitlines()\n"
            "p = ricochet.Problem(lambda x: (x[0] - 1) ** 2, [-3], [4], gradient=lambda x: [2 * x[0] - 2])\n"
            "r = ricochet.Problem(None, [-3], [4], residuals=lambda x: [x[0] - 1, 0])\n"
            "for solver, problem in [('scipy-slsqp', p), ('tao-pounders', r), ('ipopt', p)]:\n"
            "    try:\n"
            "        print(round(ricochet.minimise(problem, solver, 100).x[0], 4))\n"
            "    except ricochet.Error as error:\n"
            "        assert 'this build has no' in str(error), error\n"
            "added = subprocess.run('env', capture_output=True).stdout.splitlines()\n"
            "assert set(added) == set(before), set(added) ^ set(before)\n"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertLessEqual(set(done.stdout.split()), {"1.0"})


class Compare(unittest.TestCase):
    @needs_pandas
    def test_runs_each_solver_from_the_same_starts(self):
        first = []

        def f(x):
            first.append(x[0])
            return bowl(x)

        problem = ricochet.Problem(f, *BOX, start=[4, 4])
        solvers = ["nlopt-sbplx", "nlopt-cobyla", "random-search"]
        frame = ricochet.compare([problem], solvers, budget=100, starts=3)
        self.assertEqual(len(frame), 9)
        begins = numpy.array(first).reshape(9, 100)[:, 0]
        self.assertEqual(begins[0], 4)
        for k in range(3):
            self.assertEqual(len(set(begins[3 * k : 3 * k + 3])), 1, "one start for all solvers")
        self.assertEqual(len(set(begins)), 3)
        self.assertEqual(frame["solver"].tolist(), solvers * 3)
        self.assertTrue((frame["evaluations"] == 100).all())
        shares = frame.groupby("solver")["targets"].mean()
        self.assertEqual(shares["nlopt-cobyla"], 1)
        self.assertLess(shares["random-search"], 1)
        again = ricochet.compare([problem], solvers, budget=100, starts=3)
        self.assertEqual(frame["value"].tolist(), again["value"].tolist())
        alone = ricochet.compare(problem, ["random-search"], budget=100, starts=3)
        self.assertEqual(
            alone["value"].tolist(), frame[frame["solver"] == "random-search"]["value"].tolist()
        )

    @needs_pandas
    def test_scores_maximisation_and_runs_without_a_feasible_point(self):
        top = ricochet.Problem(lambda x: 3 - bowl(x), *BOX, maximise=True, name="top")
        none = ricochet.Problem(bowl, *BOX, constraints=[lambda x: 1], name="none")
        frame = ricochet.compare([top, none], ["nlopt-bobyqa"], budget=100, starts=2)
        scored = frame[frame["problem"] == "top"]
        self.assertTrue((scored["value"] > 2.999).all())
        self.assertTrue((scored["targets"] == 1).all())
        lost = frame[frame["problem"] == "none"]
        self.assertTrue(lost["value"].isna().all())
        self.assertTrue((lost["targets"] == 0).all())

    @needs_pandas
    def test_says_what_is_wrong(self):
        problem = ricochet.Problem(bowl, *BOX)
        with self.assertRaisesRegex(ValueError, "two problems have the name bowl"):
            ricochet.compare([problem, problem], ["auto"])
        with self.assertRaisesRegex(ValueError, "starts 0: must be >= 1"):
            ricochet.compare(problem, ["auto"], starts=0)
        with self.assertRaisesRegex(ValueError, "at least one"):
            ricochet.compare(problem, [])


class Refuses(unittest.TestCase):
    def test_what_does_not_fit_together(self):
        square = {"f": bowl, "lower": [0, 0], "upper": [1, 1]}
        for error, reason, given in [
            (TypeError, "a function f, or residuals, and not both", {"f": None}),
            (TypeError, "and not both", {"residuals": bowl}),
            (TypeError, "f must be a function, not 3", {"f": 3}),
            (TypeError, "residuals, which are missing", {"jacobian": bowl}),
            (ValueError, r"lower has 1 numbers, upper 2", {"lower": 0}),
            (ValueError, r"upper\[1\] = -1.0: must be >= lower\[1\] = 0.0", {"upper": [1, -1]}),
            (ValueError, "lower must be finite", {"lower": [0, -numpy.inf]}),
            (ValueError, r"start\[0\] = 2.0: must be from 0.0 to 1.0", {"start": [2, 0]}),
            (ValueError, r"start must be of shape \(2,\)", {"start": [0]}),
            (TypeError, r'constraints\[0\]: give a pair .* not a dictionary', {"constraints": [{}]}),
            (TypeError, r"constraints\[1\]: must be a function", {"constraints": [bowl, 3]}),
            (ValueError, r"constraints\[0\]: '< 0'; allowed are", {"constraints": [(bowl, "< 0")]}),
            (ValueError, r"constraints\[0\] has no gradient", {"gradient": bowl, "constraints": [bowl]}),
            (ValueError, "gradient_cost 0: must be >= 1", {"gradient_cost": 0}),
        ]:
            with self.subTest(reason=reason), self.assertRaisesRegex(error, reason):
                ricochet.Problem(**{**square, **given})

    def test_a_run_that_cannot_be(self):
        problem = ricochet.Problem(bowl, *BOX)
        for error, reason, given in [
            (ricochet.Error, "did you mean nlopt-cobyla", {"solver": "nlopt-cobila"}),
            (ricochet.Error, "ipopt does not take the problem", {"solver": "ipopt"}),
            (ValueError, "budget 0: must be from 1", {"budget": 0}),
            (ValueError, "seed -1: must be from 0", {"seed": -1}),
        ]:
            with self.subTest(reason=reason), self.assertRaisesRegex(error, reason):
                ricochet.minimise(problem, **given)
        with self.assertRaisesRegex(TypeError, "must be a ricochet.Problem"):
            ricochet.minimise(bowl)


if __name__ == "__main__":
    unittest.main()
