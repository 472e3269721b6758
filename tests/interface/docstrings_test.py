"""Runs every example in a docstring of the package ricochet."""

import doctest
import os
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("skipped: this Python has no NumPy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

import ricochet

NEEDS_PANDAS = {"compare", "runs"}
NO_EXAMPLE = {"solver", "SearchedProblem"}  # need a whole program: see python_solver_test.py
RESULTS = {  # of what has an example
    "Error", "Evaluated", "Impacts", "Path", "Regime", "Result", "RunOver", "Simulation",
    "Threshold", "TrueValues", "Variable",
}  # fmt: skip


def prepare(folder):
    """Makes the files that the examples read, in the working folder."""
    shutil.copy(os.path.join(os.environ["RICOCHET_SOURCE"], "examples", "machine.toml"), folder)
    subprocess.run(
        [os.environ["RICOCHET_PROGRAM"], "compare", "--problems", "classic-sphere-5",
         "--solvers", "random-search", "--budget", "20", "--instances", "2", "--out", "mine"],
        cwd=folder, check=True, capture_output=True,
    )  # fmt: skip
    os.rename(os.path.join(folder, "mine", "runs.sqlite"), os.path.join(folder, "runs.sqlite"))


def examples():
    """Every docstring that has examples: pairs of what it belongs to, and its test."""
    names = {"ricochet": ricochet, "numpy": numpy}
    about = doctest.DocTestParser().get_doctest(ricochet.__doc__, names, "ricochet", None, 0)
    yield "the package", about
    finder = doctest.DocTestFinder()
    for name in ricochet.__all__:
        for test in finder.find(getattr(ricochet, name), name, module=False, globs=names):
            if test.examples:
                yield name, test


def main():
    try:
        import pandas  # noqa: F401
    except ImportError:
        pandas = None
    tested, failed = set(), 0
    with tempfile.TemporaryDirectory() as folder:
        prepare(folder)
        os.chdir(folder)
        runner = doctest.DocTestRunner()
        for name, test in examples():
            tested.add(name)
            if name in NEEDS_PANDAS and pandas is None:
                print(f"skipped: ricochet.{name} (this Python has no pandas, Debian: python3-pandas)")
                continue
            failed += runner.run(test).failed
        os.chdir("/")
    for name in sorted(set(ricochet.__all__) - NO_EXAMPLE - RESULTS - tested):
        print(f"{name} has no example")
        failed += 1
    print(f"{runner.tries} examples of {', '.join(sorted(tested))}: {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
