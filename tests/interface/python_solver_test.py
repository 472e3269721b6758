"""ricochet.solver and ricochet.runs: programs that the program ricochet runs and compares."""

import importlib.util
import json
import os
import shlex
import sqlite3
import subprocess
import sys
import tempfile
import textwrap
import unittest

try:
    import numpy
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

import ricochet


def has(module):
    return importlib.util.find_spec(module) is not None


class Folder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name

    def ricochet(self, *arguments, fails=False):
        # No library: a solver needs none.
        environment = {**os.environ, "RICOCHET_LIBRARY": "/nowhere.so"}
        done = subprocess.run(
            [os.environ["RICOCHET_PROGRAM"], *arguments],
            cwd=self.folder, env=environment, capture_output=True, text=True,
        )  # fmt: skip
        if bool(done.returncode) != fails:
            raise AssertionError(done.stdout + done.stderr)
        self.said = done.stderr
        return done.stdout

    def solver(self, text, **options):
        """A program that calls ricochet.solver(minimise, ...)."""
        path = os.path.join(self.folder, "mine.py")
        settings = "".join(f", {name}={value!r}" for name, value in options.items())
        with open(path, "w") as file:
            file.write("import numpy, ricochet\n" + textwrap.dedent(text))
            file.write(f"\nricochet.solver(minimise, name='mine'{settings})\n")
        return f"{sys.executable} {shlex.quote(path)}"

    def solve(self, solver, problem, *options, fails=False):
        text = self.ricochet("solve", solver, problem, "--format", "json", *options, fails=fails)
        return json.loads(text)


class Solver(Folder):
    def test_returns_a_point(self):
        solver = self.solver(
            """
            def minimise(problem):
                print("to standard error")
                x = numpy.linspace(problem.lower, problem.upper, 11)[5]
                problem(x)
                return x, f"asked once of {problem.budget}, {problem.remaining} left"
            """
        )
        run = self.solve(solver, "classic-sphere-5", "--budget", "1", "--instance", "1")
        self.assertIn("to standard error", self.said)
        self.assertEqual(run["failure"], "")
        self.assertEqual(run["evaluations"], 1)
        run = self.solve(solver, "classic-sphere-5", "--budget", "3")
        self.assertEqual(run["terminations"][0], "asked once of 3, 2 left")
        self.assertEqual(run["evaluations"], 3)

    def test_sees_the_same_values_as_the_library(self):
        solver = self.solver(
            """
            import sys
            def minimise(problem):
                if problem.budget != 119:
                    return problem.start  # a later start, with what is left
                x = problem.lower + (problem.upper - problem.lower) / 3
                values = problem.objective(x), problem.constraint_values(x)
                assert problem.remaining == problem.budget - 1, "two parts of one point"
                told = [values[0], values[1].tolist(), problem.gradient(x).tolist(),
                        problem.jacobian(x).tolist()]
                assert problem.remaining == problem.budget - 5
                many = problem.batch([x, problem.start, problem.upper])
                assert problem.remaining == problem.budget - 8
                assert many.objectives[0] == values[0]
                assert many.constraints[0].tolist() == values[1].tolist()
                assert problem.batch(numpy.empty((0, 4))).constraints.shape == (0, 2)
                assert problem.objective(x) == values[0]
                assert problem.remaining == problem.budget - 9, "asked again"
                assert problem.values(x)[0] == values[0]
                assert problem.remaining == problem.budget - 10, "one of its parts again"
                assert problem.gradient(x).tolist() == told[2]
                assert problem.remaining == problem.budget - 14
                assert problem.gradient(x).tolist() == told[2]
                assert problem.remaining == problem.budget - 19, "with its value, again"
                open("told", "w").write(repr(told))
            """,
            takes_constraints=2, needs_derivatives=True,
        )  # fmt: skip
        run = self.solve(solver, "hs-71", "--budget", "119")
        self.assertEqual(run["failure"], "")
        self.assertEqual(run["formulation"], "original")
        with open(os.path.join(self.folder, "told")) as file:
            objective, constraints, gradient, jacobian = eval(file.read())
        q = ricochet.problem("hs-71")
        expected = q.derivatives(q.lower + (q.upper - q.lower) / 3)
        self.assertEqual(objective, expected[0])
        self.assertEqual(constraints, expected[1].tolist())
        self.assertEqual(gradient, expected[2].tolist())
        self.assertEqual(jacobian, expected[3].tolist())

    def test_sees_residuals(self):
        solver = self.solver(
            """
            def minimise(problem):
                residuals = problem.residuals(problem.start)
                assert problem.remaining == problem.budget - 1
                rows = problem.residual_jacobian(problem.start)
                assert problem.remaining == problem.budget - 1 - problem.dimension
                assert rows.shape == (45, 9) and residuals.shape == (45,)
                # Linear: one step of Gauss and Newton is exact.
                return problem.start - numpy.linalg.lstsq(rows, residuals, rcond=None)[0]
            """,
            needs_residuals=True,
        )
        run = self.solve(solver, "least-squares-01-linear-full-rank-9x45", "--budget", "10")
        self.assertEqual(run["failure"], "")
        self.assertTrue(run["returned_solved"])

    def test_is_told_that_the_budget_is_spent(self):
        solver = self.solver(
            """
            def minimise(problem):
                draw = numpy.random.default_rng(problem.seed)
                while True:
                    try:
                        problem(draw.uniform(problem.lower, problem.upper))
                    except ricochet.RunOver:
                        assert problem.remaining == 0
                        problem(problem.start)  # which ends it again
            """,
            stochastic=True,
        )
        for _ in range(2):
            run = self.solve(solver, "count-C1", "--budget", "30")
            self.assertEqual((run["failure"], run["evaluations"]), ("", 30))
            run.pop("seconds")
            self.assertEqual(run, getattr(self, "before", run))
            self.before = run

    def test_fails_with_its_exception(self):
        solver = self.solver("def minimise(problem): raise ValueError('mine alone')")
        run = self.solve(solver, "count-C1", "--budget", "3", fails=True)
        self.assertIn("ended with exit code 1", run["failure"])
        self.assertIn("ValueError: mine alone", self.said)

    @unittest.skipUnless(has("scipy"), "this Python has no SciPy (Debian: python3-scipy)")
    def test_is_the_example(self):
        example = os.path.join(os.environ["RICOCHET_SOURCE"], "examples", "solvers", "powell.py")
        run = self.solve(f"{sys.executable} {example}", "classic-sphere-5", "--budget", "1000")
        self.assertEqual(run["failure"], "")
        self.assertTrue(run["solved"])


@unittest.skipUnless(has("pandas"), "this Python has no pandas (Debian: python3-pandas)")
class Runs(Folder):
    def test_are_those_of_a_comparison(self):
        solver = self.solver("def minimise(problem): return problem.start, 'at once'")
        self.ricochet(
            "compare", "--problems", "count-C1,hs-71", "--solver", solver, "--solvers",
            "random-search", "--budget", "20", "--instances", "2", "--out", "out",
        )  # fmt: skip
        store = os.path.join(self.folder, "out", "runs.sqlite")
        frame = ricochet.runs(store)
        with sqlite3.connect(store) as connection:
            (number,) = connection.execute("SELECT count(*) FROM run").fetchone()
        self.assertEqual(len(frame), number)
        self.assertGreater(number, 4)
        self.assertEqual(set(frame["solver"]), {"mine", "random-search"})
        self.assertLessEqual({"count-C1", "hs-71"}, set(frame["problem"]))
        self.assertEqual(frame["objective"].dtype, float)
        best = frame[frame["problem"] == "count-C1"].groupby("solver")["objective"].min()
        self.assertGreaterEqual(best["random-search"], ricochet.problem("count-C1").best_known)

    def test_have_numbers_that_sqlite_would_change(self):
        self.ricochet(
            "compare", "--problems", "count-C1", "--solvers", "random-search", "--budget", "20",
            "--instances", "2", "--out", "out",
        )  # fmt: skip
        store = os.path.join(self.folder, "out", "runs.sqlite")
        with sqlite3.connect(store) as connection:
            connection.execute(
                "UPDATE improvement SET objective = ?", (numpy.float64(-0.0).tobytes(),)
            )
        objectives = ricochet.runs(store)["objective"]
        self.assertTrue((objectives == 0).all() and numpy.signbit(objectives).all())

    def test_are_refused_of_another_file(self):
        other = os.path.join(self.folder, "other.sqlite")
        with self.assertRaisesRegex(ricochet.Error, "other.sqlite: unable to open"):
            ricochet.runs(other)
        sqlite3.connect(other).execute("CREATE TABLE run (number)")
        with self.assertRaisesRegex(ricochet.Error, "other.sqlite: is no store of ricochet"):
            ricochet.runs(other)
        with open(other, "w") as file:
            file.write("no database" * 100)
        with self.assertRaisesRegex(ricochet.Error, "other.sqlite: file is not a database"):
            ricochet.runs(other)


if __name__ == "__main__":
    unittest.main()
