"""ricochet's problems in an experiment of COCO's form: python3 examples/coco_style.py results

`Suite` and `Observer` have the names and members that an experiment uses of cocoex's (documented at
https://coco-platform.org/getting-started): whatever solves `for problem in suite` there does so here.
cocoex itself opens only COCO's own suites, so this file needs no COCO.
"""

import csv
import fnmatch
import pathlib
import sys

import numpy
import ricochet


class Problem:
    """A problem as cocoex shows one: callable, with its box, its constraints and its evaluations."""

    def __init__(self, name, formulation, instance):
        self._problem = ricochet.problem(name, formulation, instance=instance)
        self.id = f"{name}_{formulation or 'original'}_i{instance:02d}_d{self._problem.dimension:02d}"
        self.dimension = self._problem.dimension
        self.number_of_constraints = self._problem.constraints
        self.lower_bounds, self.upper_bounds = self._problem.lower, self._problem.upper
        self.initial_solution = self._problem.start.copy()
        self.evaluations, self.evaluations_constraints = 0, 0
        self.best_observed_fvalue1 = numpy.inf
        self._observer = None

    def observe_with(self, observer):
        self._observer = observer

    def __call__(self, x):
        self.evaluations += 1
        true = self._problem.judge(x)
        if true.violation <= 1e-6 and true.objective < self.best_observed_fvalue1:
            self.best_observed_fvalue1 = true.objective
            if self._observer:
                self._observer.note(self)
        return self._problem.objective(x)

    def constraint(self, x):
        """All values <= 0 if x is feasible: an equality is two inequalities."""
        self.evaluations_constraints += 1
        values = self._problem.constraint_values(x)
        equalities = values[: self._problem.equalities]
        return numpy.concatenate([equalities, -equalities, values[self._problem.equalities :]])

    def free(self):
        self._problem.close()


class Suite:
    """The problems whose names fit a pattern, in one formulation, on some instances."""

    def __init__(self, pattern, formulation="", instances=(1, 2, 3)):
        self._keys = [
            (name, formulation, instance)
            for name in fnmatch.filter(ricochet.problems(), pattern)
            for instance in instances
        ]

    def __len__(self):
        return len(self._keys)

    def __iter__(self):
        for key in self._keys:
            problem = Problem(*key)
            yield problem
            problem.free()


class Observer:
    """Writes every improvement of the true objective at a feasible point to improvements.csv."""

    def __init__(self, result_folder):
        self.result_folder = pathlib.Path(result_folder)
        self.result_folder.mkdir(parents=True, exist_ok=True)
        self._rows = csv.writer(open(self.result_folder / "improvements.csv", "w", newline=""))
        self._rows.writerow(["problem", "evaluations", "objective"])

    def note(self, problem):
        self._rows.writerow([problem.id, problem.evaluations, problem.best_observed_fvalue1])


def random_search(problem, budget, draw):
    problem(problem.initial_solution)
    while problem.evaluations < budget:
        problem(draw.uniform(problem.lower_bounds, problem.upper_bounds))


if __name__ == "__main__":
    observer = Observer(sys.argv[1])
    for problem in Suite("count-C[14]"):
        problem.observe_with(observer)
        random_search(problem, 50 * problem.dimension, numpy.random.default_rng(1))
        print(f"{problem.id}: {problem.best_observed_fvalue1:g} after {problem.evaluations} evaluations")
