"""The problems of the package ricochet, against the program ricochet and against SciPy."""

import json
import math
import os
import pickle
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
    import scipy.optimize
except ImportError:
    scipy = None

import ricochet

needs_proc = unittest.skipUnless(os.path.exists("/proc/self/statm"), "there is no /proc")
needs_scipy = unittest.skipUnless(scipy, "this Python has no SciPy (Debian: python3-scipy)")


def evaluated(name, points, *options):
    """What `ricochet evaluate` answers to points, or to objects with all keys."""
    asked = [x if isinstance(x, dict) else list(x) for x in points]
    text = "".join(json.dumps(each) + "\n" for each in asked)
    done = subprocess.run(
        [os.environ["RICOCHET_PROGRAM"], "evaluate", name, *options],
        input=text, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [json.loads(line) for line in done.stdout.splitlines()]


def some_points(q, count=20):
    draw = numpy.random.default_rng(1)
    return draw.uniform(q.lower, q.upper, (count, q.dimension))


def evolved(q, function, **options):
    """The least value that SciPy's differential evolution finds in five generations."""
    bounds = scipy.optimize.Bounds(q.lower, q.upper)
    return scipy.optimize.differential_evolution(
        function, bounds, seed=1, maxiter=5, polish=False, updating="deferred", **options
    ).fun


class Values(unittest.TestCase):
    def test_are_those_of_the_program_bit_for_bit(self):
        for name, formulation in [
            ("count-C1", "count"),
            ("count-C9", "surrogate"),
            ("top-speed-C4", "surrogate"),
            ("profile-wear-8-C2", ""),
            ("hs-71", ""),
            ("hard-top-speed-01", "penalised-count"),
        ]:
            for instance in (0, 3):
                with self.subTest(name=name, formulation=formulation, instance=instance):
                    q = ricochet.problem(name, formulation, instance=instance)
                    points = some_points(q)
                    options = ["--instance", str(instance)]
                    options += ["--formulation", formulation] if formulation else []
                    for x, answer in zip(points, evaluated(name, points, *options)):
                        objective, constraints = q.values(x)
                        self.assertEqual(objective, answer["objective"])
                        self.assertEqual(constraints.tolist(), answer["constraints"])
                        true_values = q.judge(x)
                        self.assertEqual(true_values._asdict(), answer["true_values"])

    def test_of_a_machine_file_are_those_of_the_program(self):
        scene = os.path.join(os.environ["RICOCHET_SOURCE"], "examples", "machine.toml")
        with ricochet.problem("profile-wear-8-scene", scene=scene) as q:
            points = some_points(q)
            answers = evaluated(q.name, points, "--scene", scene)
            for x, answer in zip(points, answers):
                self.assertEqual(q.objective(x), answer["objective"])
        with self.assertRaisesRegex(ricochet.Error, "none.toml"):
            ricochet.problem("count-scene", scene="none.toml")

    def test_have_the_derivatives_of_the_program_bit_for_bit(self):
        for name, formulation in [("hs-71", ""), ("top-speed-C1", "surrogate")]:
            with self.subTest(name=name):
                q = ricochet.problem(name, formulation)
                points = some_points(q, 10)
                options = ["--derivatives"] + (["--formulation", formulation] if formulation else [])
                for x, answer in zip(points, evaluated(name, points, *options)):
                    objective, constraints, gradient, jacobian = q.derivatives(x)
                    self.assertEqual(objective, answer["objective"])
                    self.assertEqual(constraints.tolist(), answer["constraints"])
                    self.assertEqual(gradient.tolist(), answer["gradient"])
                    self.assertEqual(jacobian.tolist(), answer["jacobian"])
                    self.assertEqual(q.gradient(x).tolist(), gradient.tolist())
                    self.assertEqual(q.jacobian(x).tolist(), jacobian.tolist())

    def test_have_the_residuals_of_the_program_bit_for_bit(self):
        name = "least-squares-01-linear-full-rank-9x45"
        q = ricochet.problem(name)
        points = some_points(q, 5)
        asked = [{"x": list(x), "residuals": True, "derivatives": True} for x in points]
        for x, answer in zip(points, evaluated(name, asked)):
            before = q.remaining
            residuals = q.residuals(x)
            self.assertEqual(before - q.remaining, 1)
            self.assertEqual(residuals.tolist(), answer["residuals"])
            self.assertEqual(q.residual_jacobian(x).tolist(), answer["residual_jacobian"])
            self.assertEqual(before - q.remaining, 1 + q.dimension)
        with self.assertRaisesRegex(ricochet.Error, "hs-71 has no residuals"):
            ricochet.problem("hs-71").residuals([1, 2, 3, 4])

    def test_are_new_arrays_each_time(self):
        q = ricochet.problem("hs-71")
        first = q.constraint_values([1, 2, 3, 4])
        before = first.copy()
        q.constraint_values([4, 3, 2, 1])
        self.assertEqual(first.tolist(), before.tolist())


class Problem(unittest.TestCase):
    def test_says_what_it_is(self):
        q = ricochet.problem("hs-71")
        (described,) = evaluated("hs-71", [], "--describe")
        self.assertEqual(q.name, "hs-71")
        self.assertEqual(q.dimension, described["dimension"])
        self.assertEqual(q.constraints, described["constraints"])
        self.assertEqual(q.equalities, described["equalities"])
        self.assertEqual(q.has_derivatives, described["derivatives"])
        self.assertEqual(q.lower.tolist(), described["lower"])
        self.assertEqual(q.upper.tolist(), described["upper"])
        self.assertEqual(q.start.tolist(), described["start"])
        self.assertEqual(q.best_known, described["best_known"])
        self.assertEqual(q.tolerance, described["tolerance"])
        with self.assertRaises(ValueError):
            q.lower[0] = 0

    def test_names_its_variables_and_their_units(self):
        q = ricochet.problem("design-count-C1", instance=2)
        (described,) = evaluated(q.name, [], "--describe", "--instance", "2")
        self.assertEqual([v._asdict() for v in q.variables], described["variables"])
        self.assertGreater(len({v.unit for v in q.variables}), 1)
        self.assertEqual(ricochet.problem("top-speed-C1").unit, "rad/s")

    def test_is_one_of_those_listed(self):
        names = ricochet.problems()
        self.assertGreater(len(names), 200)
        self.assertEqual(len(set(names)), len(names))
        self.assertIn("top-speed-C1", names)

    def test_is_a_function_where_nothing_constrains_it(self):
        q = ricochet.problem("count-C1")
        self.assertIs(type(q(5.0)), float)
        self.assertEqual(q(5.0), q([5.0]))
        self.assertEqual(q(numpy.array([5])), q(5))
        with self.assertRaisesRegex(TypeError, "hs-71 has 2 constraints"):
            ricochet.problem("hs-71")([1, 5, 5, 1])

    def test_counts_as_the_suite_does(self):
        q = ricochet.problem("hs-71", budget=10)
        q.objective([1, 2, 3, 4])
        q.constraint_values([1, 2, 3, 4])
        self.assertEqual(q.remaining, 9)
        q.gradient([1, 2, 3, 4])
        q.jacobian([1, 2, 3, 4])
        self.assertEqual(q.remaining, 5)
        q.judge([1, 2, 3, 4])
        self.assertEqual(q.remaining, 5)
        for k in range(5):
            q.values([1, 2, 3, 4 + k / 8])
        with self.assertRaisesRegex(ricochet.RunOver, "budget of 10 evaluations is spent"):
            q.values([1, 1, 1, 1])

    def test_draws_the_same_from_the_same_seed(self):
        def draws(seed):
            q = ricochet.problem("hs-71", seed=seed)
            return [q.uniform() for _ in range(10)]

        self.assertEqual(draws(2**64 - 1), draws(2**64 - 1))
        self.assertNotEqual(draws(1), draws(2))

    def test_is_closed_once(self):
        with ricochet.problem("hs-71") as q:
            self.assertIn("hs-71", repr(q))
        q.close()
        self.assertIn("closed", repr(q))
        for ask in (lambda: q.values([1, 1, 1, 1]), lambda: q.remaining, q.uniform):
            with self.assertRaisesRegex(ricochet.Error, "hs-71 is closed"):
                ask()

    def test_is_open_in_each_of_many_threads(self):
        expected = ricochet.problem("count-C4", "surrogate")(5.0)
        found = []

        def work():
            for _ in range(20):
                with ricochet.problem("count-C4", "surrogate") as q:
                    found.append(q(5.0))

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [expected] * 80)


def at_once(ask, points):
    """What `ask` gives at each point, by eight threads."""
    found = [None] * len(points)

    def work(first):
        for k in range(first, len(points), 8):
            found[k] = ask(points[k])

    threads = [threading.Thread(target=work, args=(first,)) for first in range(8)]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)  # within a call, too
    try:
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        sys.setswitchinterval(interval)
    return found


class Threads(unittest.TestCase):
    """Each thread gets the values of its own points from a problem that all share."""

    def check(self, name, formulation, *asks):
        with ricochet.problem(name, formulation) as q:
            points = some_points(q, 800)
            for ask in asks:
                expected = [getattr(q, ask)(x) for x in points]
                found = at_once(getattr(q, ask), points)
                for one, many in zip(expected, found):
                    numpy.testing.assert_equal(many, one, ask)

    def test_get_values(self):
        self.check("design-count-C1", "", "objective", "values", "judge")
        self.check("top-speed-C1", "count", "values", "constraint_values")

    def test_get_derivatives(self):
        self.check("hs-71", "", "values", "gradient", "jacobian", "derivatives")
        self.check("top-speed-C4", "surrogate", "gradient", "derivatives")

    def test_get_residuals(self):
        name = "least-squares-08-rosenbrock-2x2-far"
        self.check(name, "", "residuals", "residual_jacobian", "gradient")

    def test_share_a_budget(self):
        with ricochet.problem("hs-71", budget=500) as q:
            def ask(x):
                try:
                    return q.values(x)
                except ricochet.RunOver:
                    return None

            found = at_once(ask, some_points(q, 800))
            self.assertEqual(sum(each is not None for each in found), 500)
            self.assertEqual(q.remaining, 0)

    def test_draw_all_numbers_of_the_seed_once(self):
        with ricochet.problem("hs-71", seed=3) as alone, ricochet.problem("hs-71", seed=3) as q:
            expected = sorted(alone.uniform() for _ in range(800))
            self.assertEqual(sorted(at_once(lambda _: q.uniform(), range(800))), expected)

    def test_may_close_what_others_use(self):
        for _ in range(20):
            q = ricochet.problem("count-C4", "surrogate")

            def ask(k):
                if k == 100:
                    q.close()
                try:
                    return q(5.0)
                except ricochet.Error:
                    return None

            found = set(at_once(ask, range(200)))
            self.assertLessEqual(len(found - {None}), 1)


class Batch(unittest.TestCase):
    def test_has_the_values_of_its_points(self):
        for name in ("hs-71", "count-C4", "top-speed-C1"):
            q = ricochet.problem(name, budget=40)
            points = some_points(q, 20)
            told = q.batch(points)
            self.assertEqual(q.remaining, 20)
            self.assertEqual(told.constraints.shape, (20, q.constraints))
            for x, objective, constraints in zip(points, *told):
                expected, limits = q.values(x)
                self.assertEqual(objective, expected)
                self.assertEqual(constraints.tolist(), limits.tolist())

    def test_takes_points_in_any_order_of_memory(self):
        q = ricochet.problem("hs-71")
        points = some_points(q, 6)
        expected = q.batch(points).objectives.tolist()
        self.assertEqual(q.batch(numpy.asfortranarray(points)).objectives.tolist(), expected)
        self.assertEqual(q.batch(points.tolist()).objectives.tolist(), expected)
        self.assertEqual(q.batch(points[::2]).objectives.tolist(), expected[::2])
        self.assertEqual(q.batch(numpy.empty((0, 4))).objectives.shape, (0,))

    def test_is_refused_whole(self):
        q = ricochet.problem("hs-71", budget=3)
        points = some_points(q, 4)
        with self.assertRaisesRegex(ricochet.RunOver, "4 points, but 3 evaluations are left"):
            q.batch(points)
        for bad in (points[0], points[:, :3], points * math.nan, [[]]):
            with self.assertRaises(ValueError):
                q.batch(bad)
        self.assertEqual(q.remaining, 3)
        self.assertEqual(len(q.batch(points[:3]).objectives), 3)

    @needs_scipy
    def test_is_what_scipy_calls_vectorized(self):
        q = ricochet.problem("profile-count-8-C4")
        found = evolved(q, lambda x: q.batch(x.T).objectives, vectorized=True)
        self.assertEqual(found, evolved(q, q))


class Copy(unittest.TestCase):
    def test_is_the_same_problem(self):
        scene = os.path.join(os.environ["RICOCHET_SOURCE"], "examples", "machine.toml")
        for q in (
            ricochet.problem("top-speed-C4", "surrogate", instance=2, seed=5),
            ricochet.problem("profile-wear-8-scene", scene=scene),
        ):
            copy = pickle.loads(pickle.dumps(q))
            for x in some_points(q, 5):
                self.assertEqual(copy.values(x)[0], q.values(x)[0])
            self.assertEqual(copy.uniform(), q.uniform())
            self.assertEqual((copy.name, copy.best_known), (q.name, q.best_known))

    def test_has_the_evaluations_that_are_left(self):
        q = ricochet.problem("hs-71", budget=5)
        q.values(q.start)
        copy = pickle.loads(pickle.dumps(q))
        self.assertEqual(copy.remaining, 4)
        copy.batch([q.start] * 4)
        self.assertEqual((copy.remaining, q.remaining), (0, 4))
        with self.assertRaisesRegex(ricochet.RunOver, "hs-71 cannot be copied"):
            pickle.dumps(copy)
        q.close()
        with self.assertRaisesRegex(ricochet.Error, "hs-71 is closed"):
            pickle.dumps(q)

    @needs_scipy
    def test_is_evaluated_by_workers(self):
        q = ricochet.problem("profile-count-8-C4")
        self.assertEqual(evolved(q, q, workers=1), evolved(q, q, workers=2))


class BadInput(unittest.TestCase):
    def test_is_named(self):
        for arguments, complaint in [
            (("top-sped-C1",), "did you mean top-speed-C1"),
            (("",), "no such problem"),
            (("hs-71", "surrogate"), "hs-71 has no such formulation; allowed: original"),
            (("hs-71\n",), r"hs-71\\x0a: there is no such problem"),
        ]:
            with self.assertRaisesRegex(ricochet.Error, complaint):
                ricochet.problem(*arguments)
        for options in [{"instance": -1}, {"budget": 0}, {"seed": -1}, {"seed": 2**64}]:
            with self.assertRaises(ValueError):
                ricochet.problem("hs-71", **options)

    def test_does_not_end_the_run(self):
        q = ricochet.problem("hs-71", budget=3)
        for x in [
            [1, 2, 3], [1, 2, 3, 4, 5], [[1, 2, 3, 4]], 1, [],
            [1, 2, 3, math.nan], [1, 2, 3, math.inf], [1, 2, 3, None], "four",
        ]:  # fmt: skip
            with self.subTest(x=x), self.assertRaises((ValueError, TypeError)):
                q.values(x)
        self.assertEqual(q.remaining, 3)

    def test_is_asking_for_derivatives_where_there_are_none(self):
        q = ricochet.problem("count-C1")
        with self.assertRaisesRegex(ricochet.Error, "count-C1 has no derivatives in this formulation"):
            q.gradient(5.0)
        self.assertIs(type(q(5.0)), float)


@needs_scipy
class SciPy(unittest.TestCase):
    def test_solves_a_problem_with_constraints(self):
        q = ricochet.problem("hs-71", budget=1000)
        limit = numpy.where(numpy.arange(q.constraints) < q.equalities, 0, -numpy.inf)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that both kinds of constraints come in one function
            result = scipy.optimize.minimize(
                q.objective, q.start, jac=q.gradient, method="SLSQP",
                bounds=scipy.optimize.Bounds(q.lower, q.upper),
                constraints=scipy.optimize.NonlinearConstraint(
                    q.constraint_values, limit, 0, jac=q.jacobian
                ),
            )  # fmt: skip
        true_values = q.judge(result.x)
        self.assertLess(true_values.violation, 1e-6)
        self.assertAlmostEqual(true_values.objective, 17.0140173, delta=1e-5)  # published

    def test_finds_the_fewest_collisions(self):
        q = ricochet.problem("count-C1")
        (described,) = evaluated("count-C1", [], "--describe")
        result = scipy.optimize.differential_evolution(
            q, scipy.optimize.Bounds(q.lower, q.upper), seed=1, maxiter=50
        )
        self.assertEqual(q.judge(result.x).objective, described["best_known"])

    def test_ends_when_the_budget_does(self):
        q = ricochet.problem("profile-count-8-C4", budget=100)
        with self.assertRaises(ricochet.RunOver):
            scipy.optimize.differential_evolution(q, list(zip(q.lower, q.upper)), seed=1)
        self.assertEqual(q.remaining, 0)


class Library(unittest.TestCase):
    def test_is_missed_with_a_reason(self):
        done = subprocess.run(
            [sys.executable, "-c", "import ricochet; ricochet.problems()"],
            env={**os.environ, "RICOCHET_LIBRARY": "/nowhere.so"}, capture_output=True, text=True,
        )  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertIn("ImportError: ricochet: /nowhere.so cannot be loaded", done.stderr)

    def test_has_the_version_of_the_package(self):
        done = subprocess.run(
            [os.environ["RICOCHET_PROGRAM"], "--version"], capture_output=True, text=True
        )
        self.assertIn(ricochet.__version__, done.stdout.split()[1])

    def test_lets_a_program_end_with_problems_open(self):
        done = subprocess.run(
            [sys.executable, "-c", "import ricochet; q = ricochet.problem('count-C1'); q(5.0)"],
            capture_output=True, text=True,
        )  # fmt: skip
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    @needs_proc
    def test_stays_until_the_end_of_the_process(self):
        # Octave closes what it has loaded; threads of TBB would then run in code that is gone.
        use = (
            "import _ctypes, ricochet; from ricochet._library import library; ricochet.problems();"
            "ricochet.Scene.load('examples/machine.toml').threshold('collisions', 10);"
            "_ctypes.dlclose(library()._handle);"
            "print('libricochet' in open('/proc/self/maps').read())"
        )
        done = subprocess.run(
            [sys.executable, "-c", use],
            cwd=os.environ["RICOCHET_SOURCE"], capture_output=True, text=True,
        )  # fmt: skip
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "True\n", ""))

    @needs_proc
    def test_keeps_nothing_of_what_was_closed(self):
        def resident():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

        def use(times):
            for k in range(times):
                with ricochet.problem("hs-71", instance=k % 3) as q:
                    q.values(q.start)

        use(1000)
        before = resident()
        use(10_000)
        self.assertLess(resident() - before, 2e6)


if __name__ == "__main__":
    unittest.main()
