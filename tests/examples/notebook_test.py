#!/usr/bin/env python3
"""Executes the notebook in a folder of its own, without Jupyter, and compares what it found with the
program. Exit code 77: this Python has no NumPy."""
import contextlib
import csv
import io
import json
import os
import shutil
import tempfile

from examples_test import SOURCE, call, need_module

NOTEBOOK = SOURCE / "examples" / "machine_to_comparison.ipynb"


def cells_of(notebook):
    """The texts of the cells of code, which have no outputs."""
    assert notebook["nbformat"] == 4
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(cells) >= 5
    assert all(cell["outputs"] == [] and cell["execution_count"] is None for cell in cells)
    return ["".join(cell["source"]) for cell in cells]


def execute(cells):
    """All names after the cells, and what they printed. An error of a cell goes through."""
    names, printed = {"__name__": "__main__"}, io.StringIO()
    with contextlib.redirect_stdout(printed):
        for k, cell in enumerate(cells, 1):
            exec(compile(cell, f"{NOTEBOOK.name}, cell {k} of code", "exec"), names)
    return names, printed.getvalue()


def ask(*arguments, **options):
    return call(os.environ["RICOCHET_PROGRAM"], *arguments, **options)


def same_machine(names):
    """What is said of the machine is what the command line says."""
    told = json.loads(ask("threshold", "--scene", "machine.toml", "--format", "json"))
    quiet, loud = names["threshold"].quiet, names["threshold"].first_loud
    assert quiet <= told["threshold"] < loud and loud - quiet < 0.0011, (quiet, loud, told["threshold"])
    keys = {"lowest": "from", "highest": "to", "most_per_turn": "most_per_turn", "ends_by": "ends_by"}
    regimes = [{keys[name]: getattr(each, name) for name in keys} for each in names["regimes"]]
    assert regimes == [{key: each[key] for key in keys.values()} for each in told["regimes"]], regimes
    points = json.dumps(names["speeds"].reshape(-1, 1).tolist())
    counts = json.loads(ask("evaluate", "count-scene", "--scene", "machine.toml", input=points))["objective"]
    assert names["counts"].tolist() == counts and len(set(counts)) > 3
    at_quiet, at_loud = names["at_quiet"], names["at_loud"]
    assert (at_quiet.objective, at_quiet.violation) == (-quiet, 0) and at_loud.violation > 0


def same_runs(names, printed):
    """The table has the points that the program exports, and the own solver comes near the threshold."""
    store = names["folder"] / "comparison" / "runs.sqlite"
    ask("export", store, "--format", "csv", "--out", "tables")
    speeds = {}
    for row in csv.DictReader(open("tables/runs.csv")):
        if row["feasible"] == "1":
            speeds.setdefault((row["solver"], row["formulation"]), []).append(-float(row["objective"]))
    own = [all_ for (solver, _), all_ in speeds.items() if solver == "halving-steps"]
    assert len(own) == 1 and len(speeds) > 3, speeds
    assert all(0 <= names["threshold"].first_loud - speed < 0.01 for speed in own[0]), own
    if "no pandas" in printed:
        print("not tested: the frame (this Python has no pandas, Debian: python3-pandas)")
        return
    means = {pair: sum(all_) / len(all_) for pair, all_ in speeds.items()}
    shown = names["fastest"].to_dict()
    assert shown.keys() == means.keys(), (shown, means)
    assert all(abs(shown[pair] - means[pair]) < 1e-9 for pair in means), (shown, means)


def main():
    need_module("numpy")
    os.environ["MPLBACKEND"] = "Agg"
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(SOURCE / "examples" / "machine.toml", folder)
        os.environ["TMPDIR"] = folder  # for what the notebook makes
        os.chdir(folder)
        names, printed = execute(cells_of(json.loads(NOTEBOOK.read_text())))
        same_machine(names)
        same_runs(names, printed)
        os.chdir("/")


if __name__ == "__main__":
    main()
