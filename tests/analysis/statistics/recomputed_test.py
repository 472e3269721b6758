#!/usr/bin/env python3
"""The figures of a comparison, recomputed from its exported runs with Python's standard library alone."""
import collections
import csv
import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import tempfile

PLAN = """
name = "recomputed"
[[part]]
problems = ["top-speed-C[1-4]", "count-C[14]"]
solvers = ["bisection", "golden-section", "random-search", "scan", "mads", "nlopt-cobyla", "nlopt-slsqp"]
formulations = ["count", "penalised-count", "penalised-surrogate"]
budgets = [20]
instances = 4
[[part]]
problems = ["hs-[1-9]"]
solvers = ["random-search", "mads", "nlopt-cobyla", "nlopt-slsqp", "nlopt-lbfgs", "nlopt-nelder-mead"]
budgets = [40]
instances = 3
"""
SAMPLES = 4000
checked = collections.Counter()


def close(what, ours, told, tolerance):
    assert told is not None and abs(ours - told) <= tolerance, f"{what}: {ours} in Python, {told} in the report"
    checked[what.split(":")[0]] += 1


def records(data):
    """The rows of a table of data.json."""
    names = [column["name"] for column in data["columns"]]
    return [dict(zip(names, row)) for row in data["rows"]]


def table(file):
    with open(file, newline="") as text:
        return list(csv.DictReader(text))


class Run:
    def __init__(self, row, steps, best_known):
        self.charged = int(row["charged"])
        self.steps = [(int(s["evaluations"]), float(s["objective"]) - best_known)
                      for s in steps if float(s["violation"]) <= 0]
        self.found = row["solved"] == "1"
        self.solved = row["returned_solved"] == "1"
        self.gap = float(row["returned_optimality_gap"] or math.inf)
        as_good = [at for at, gap in self.steps if gap <= self.gap]
        self.cost = math.inf if self.gap == math.inf else as_good[0] if as_good else self.charged
        if self.solved:
            self.cost = int(row["evaluations_to_solve"])
        self.key = (0 if self.solved else self.gap, self.cost)


def rivals_ahead(runs):
    """The share of its rivals that are ahead of each entry, from a list of (entry, run)."""
    return {entry: sum(1 if other.key < run.key else 0.5 if other.key == run.key else 0
                       for name, other in runs if name != entry) / (len(runs) - 1) for entry, run in runs}


def means(problems):
    """By entry, over problems, each a list of instances."""
    of_problems = collections.defaultdict(list)
    for instances in problems:
        for entry in instances[0]:
            of_problems[entry].append(statistics.fmean(ahead[entry] for ahead in instances))
    return {entry: round(statistics.fmean(values), 9) for entry, values in of_problems.items()}


def firsts(values):
    least = min(values.values())
    return [entry for entry, value in values.items() if value == least]


def tau(a, b):
    """Kendall's tau-b of the entries in both."""
    both = sorted(set(a) & set(b))
    sign = lambda x: (x > 0) - (x < 0)
    pairs = [(sign(a[i] - a[k]), sign(b[i] - b[k])) for n, i in enumerate(both) for k in both[:n]]
    return sum(x * y for x, y in pairs) / math.sqrt(sum(x * x for x, _ in pairs) * sum(y * y for _, y in pairs))


def ranked_problems(cells, problems, instances):
    """For each problem and instance the shares of rivals ahead, of entries that take half of the problems."""
    takes = {entry: mine for entry, mine in cells.items() if 2 * len(mine) >= len(problems)}
    return takes, [[rivals_ahead([(entry, mine[q][i]) for entry, mine in takes.items() if q in mine])
                    for i in instances] for q in problems]


def probabilities(ranked, draw):
    times = collections.Counter()
    for _ in range(SAMPLES):
        first = firsts(means([draw.choices(instances, k=len(instances))
                              for instances in draw.choices(ranked, k=len(ranked))]))
        times.update(dict.fromkeys(first, 1 / len(first) / SAMPLES))
    return times


def check_held_out(row, ranked, draw):
    correlations, stays = [], []
    for _ in range(SAMPLES // 4):
        order = draw.sample(ranked, len(ranked))
        half = len(ranked) // 2
        a, b = means(order[:half]), means(order[half:2 * half])
        both = set(a) & set(b)
        a, b = ({e: x for e, x in half_of.items() if e in both} for half_of in (a, b))
        correlations.append(tau(a, b))
        one, other = firsts(a), firsts(b)
        stays.append(len(set(one) & set(other)) / len(one) / len(other))
    close("held out: correlation", statistics.fmean(correlations), row["correlation"], 0.03)
    close("held out: first stays", statistics.fmean(stays), row["first_stays"], 0.06)


def wilson_upper(successes, trials, z=statistics.NormalDist().inv_cdf(0.975)):
    half = z * math.sqrt(successes * (trials - successes) / trials + z * z / 4)
    return (successes + z * z / 2 + half) / (trials + z * z)


def targets(problem, tolerance):
    size, easiest = problem["targets"], problem["easiest"]
    if size == 1 or tolerance == 0.5:
        return [tolerance + k for k in range(size)]
    return [tolerance * (easiest / tolerance) ** (k / (size - 1)) for k in range(size)]


def check_results(page, cells):
    """Success rates and the expected running time, of runs that differ."""
    for row in records(page["tables"]["results"]):
        runs = cells[row["solver"], row["formulation"]][row["problem"]].values()
        distinct = {(run.charged, run.gap, tuple(run.steps)): run for run in runs}.values()
        solved = sum(run.solved for run in distinct)
        close("returned: share", solved / len(distinct), row["returned"], 1e-3)
        close("returned: upper end", wilson_upper(solved, len(distinct)), row["returned_upper"], 2e-3)
        if solved == 0:
            assert row["running_time"] is None
            continue
        spent = sum(run.cost if run.solved else run.charged for run in distinct)
        close("ERT: value", spent / solved, row["running_time"], 1e-5 * spent)


def check_family(report, family, cells, tolerances):
    page = json.loads((report / family / "data.json").read_text())["parts"]["families"][0]
    ratings = records(page["parts"]["budgets"][0]["tables"]["ratings"])
    stated = records(page["tables"]["problems"])
    problems = [problem["problem"] for problem in stated]
    instances = sorted(next(iter(next(iter(cells.values())).values())))
    takes, ranked = ranked_problems(cells, problems, instances)
    draw = random.Random(1)
    best = probabilities(ranked, draw)
    ranks = means(ranked)
    goals = {p["problem"]: targets(p, tolerances[p["problem"]]) for p in stated}
    assert len(ratings) == len(cells)
    for rating in ratings:
        entry = rating["solver"], rating["formulation"]
        mine = cells[entry]
        runs = [run for of_problem in mine.values() for run in of_problem.values()]
        close("rating: problems", len(mine), rating["takes"], 0)
        close("rating: returned", statistics.fmean(run.solved for run in runs), rating["returned"], 1e-3)
        close("rating: best evaluated", statistics.fmean(run.found for run in runs), rating["found"], 1e-3)
        reached = statistics.fmean(
            statistics.fmean(run.gap <= goal for run in mine[q].values() for goal in goals[q]) for q in mine)
        close("rating: targets reached", reached, rating["share"], 0.01)
        if entry not in takes:
            assert rating["rank"] is None and rating["best"] is None, entry
            checked["not ranked"] += 1
            continue
        close("rating: mean rank", 1 + ranks[entry] * (len(takes) - 1), rating["rank"], 0.006 * rating["rank"])
        close("rating: P(best)", best[entry], rating["best"], 0.05)
    check_results(page, cells)
    summary = json.loads((report / "data.json").read_text())["tables"]
    row = next(row for row in records(summary["held-out"]) if row["family"] == family)
    if row["correlation"] is not None:
        check_held_out(row, ranked, draw)
    halves = [means(ranked_problems(cells, problems, instances[k::2][:len(instances) // 2])[1]) for k in (0, 1)]
    for row in records(summary["orders"]):
        if row["family"] == family and row["changed"] == "the other half of the instances":
            close("orders: correlation", tau(*halves), row["correlation"], 2e-3)


def main():
    program = os.environ["RICOCHET_PROGRAM"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "plan.toml").write_text(PLAN)
        report, tables = folder / "report", folder / "tables"
        subprocess.run([program, "run", folder / "plan.toml", "--out", report, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([program, "export", report / "runs.sqlite", "--format", "csv", "--out", tables, "--quiet"],
                       check=True, stdout=subprocess.DEVNULL)
        problems = {row["problem"]: row for row in table(tables / "problems.csv")}
        steps = collections.defaultdict(list)
        for step in table(tables / "improvements.csv"):
            steps[step["number"]].append(step)
        families = collections.defaultdict(lambda: collections.defaultdict(lambda: collections.defaultdict(dict)))
        for row in table(tables / "runs.csv"):
            problem = problems[row["problem"]]
            run = Run(row, steps[row["number"]], float(problem["best_known"]))
            entry = row["solver"], row["formulation"]
            families[problem["family"]][entry][row["problem"]][int(row["instance"])] = run
        tolerances = {name: float(row["tolerance"]) for name, row in problems.items()}
        assert len(families) == 3
        for family, cells in families.items():
            check_family(report, family, cells, tolerances)
    for what in ("rating", "returned", "ERT", "held out", "orders", "not ranked"):
        assert checked[what] > 0, f"nothing checked of {what}"
    print(", ".join(f"{what}: {times}" for what, times in checked.items()))


main()
