"""The table of docs/benchmark-method.md, "In which coordinates does a solver work?", from the stores of the plan
coordinates: python3 reports/plans/coordinates.py coordinates/runs.sqlite

A run is solved at the first evaluation that is feasible and within the tolerance of the best known value; a run that is
not spends its budget. Least squares from the far start and the near one are one problem. p: of a two-sided permutation
test over problems, which exchanges the two solvers of each, 10,000 times.
"""

import math
import random
import re
import sqlite3
import sys
from collections import defaultdict

RUNS = """
SELECT solver.name, problem.name, cell.formulation, problem.family, run.evaluations_allowed,
       min(CASE WHEN violation <= 1e-6 AND objective <= best_known + tolerance THEN improvement.evaluations END)
FROM run JOIN cell ON cell.number = run.cell JOIN problem ON problem.number = cell.problem
JOIN solver ON solver.number = cell.solver LEFT JOIN improvement ON improvement.run = run.number
GROUP BY run.number
"""


def read(files):
    runs = defaultdict(lambda: defaultdict(list))  # of a solver on a problem: (solved, evaluations), by instance
    for file in files:
        for solver, problem, formulation, family, budget, solved in sqlite3.connect(file).execute(RUNS):
            name = re.sub(r"^least-squares-\d+-(.*?)(-far)?$", r"least-squares-\1", problem)
            runs[solver][name, formulation].append((solved is not None, max(1, solved or budget)))
    return runs


def p_of(differences):
    draw = random.Random(1)
    uneven = [d for d in differences if d != 0]
    far = sum(
        abs(sum(draw.choice((d, -d)) for d in uneven)) >= abs(sum(uneven)) - 1e-12 for _ in range(10_000)
    )
    return (far + 1) / 10_001


def mean(numbers):
    return sum(numbers) / len(numbers)


def compared(of, base, chosen=""):
    """How many problems, success rates, mean ratio of evaluations, and its p."""
    same = [p for p in base if p in of and len(of[p]) == len(base[p]) and p[0].startswith(chosen)]
    if not same:
        return None
    logs = [mean([math.log(a[1] / b[1]) for a, b in zip(of[p], base[p])]) for p in same]
    rates = [100 * mean([run[0] for p in same for run in runs[p]]) for runs in (base, of)]
    return len(same), rates, math.exp(mean(logs)), p_of(logs)


def ratio(found):
    if not found:
        return ""
    return f"{found[2]:.2f} ({'p < 0.001' if found[3] < 0.001 else f'p = {found[3]:.3f}'})"


runs = read(sys.argv[1:])
for base in sorted(solver for solver in runs if solver.endswith("-unit")):
    even, own = (runs[base.replace("-unit", end)] for end in ("-even", "-own"))
    all_of_it, scaled = compared(own, runs[base]), compared(even, runs[base])
    rates = (all_of_it[1][0], scaled[1][1], all_of_it[1][1])
    print(
        f"| `{base[:-5]}` | {all_of_it[0]} | {' / '.join(f'{rate:.0f}' for rate in rates)} | {ratio(scaled)} "
        f"| {ratio(all_of_it)} | {ratio(compared(own, runs[base], 'least-squares'))} |"
    )
for varied in sorted(solver for solver in runs if re.search(r"-\d+$", solver)):
    base = re.sub(r"-\d+$", "", varied)
    found = compared(runs[varied], runs[base])
    print(f"{varied}: success {found[1][0]:.0f} -> {found[1][1]:.0f} %, evaluations times {ratio(found)}")
