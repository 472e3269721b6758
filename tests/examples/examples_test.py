#!/usr/bin/env python3
"""Runs one example that needs other software: examples_test.py NAME. Exit code 77: it is not there."""
import csv
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["RICOCHET_SOURCE"])
EXAMPLES = SOURCE / "examples"
PLAN = """
name = "loaded"
[[part]]
problems = ["count-C1", "profile-count-2-C4"]
solvers = ["random-search", "nlopt-cobyla"]
formulations = ["count"]
perturbations = ["plain", "nan"]
budgets = [10]
instances = 2
"""


def need(condition, what):
    if not condition:
        print(f"skipped: needs {what}")
        sys.exit(77)


def need_module(name):
    need(importlib.util.find_spec(name), f"the Python module {name}")


def call(*command, **options):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def exported(folder):
    """A folder with the CSV export of 16 runs, and their report beside it."""
    (folder / "plan.toml").write_text(PLAN)
    program = os.environ["RICOCHET_PROGRAM"]
    call(program, "run", folder / "plan.toml", "--out", folder / "mine")
    call(program, "export", folder / "mine/runs.sqlite", "--format", "csv", "--out", folder / "tables")
    return folder / "tables"


def success_rates(tables):
    """Returned points that solve, by family, solver and perturbation, from the CSV with no library."""
    families = {row["problem"]: row["family"] for row in csv.DictReader(open(tables / "problems.csv"))}
    rates = {}
    for row in csv.DictReader(open(tables / "runs.csv")):
        key = families[row["problem"]], row["solver"], row["perturbation"]
        rates.setdefault(key, []).append(int(row["returned_solved"]))
    return {key: sum(all_) / len(all_) for key, all_ in rates.items()}


def same_rates(printed, tables):
    """Whether a printed table has every rate, and no perturbation was lost as a missing value."""
    rates = success_rates(tables)
    assert len(rates) == 8 and {key[2] for key in rates} == {"plain", "missing-value"}
    assert printed.count("missing-value") == 4, printed
    last = re.findall(r" ([01](?:\.\d+)?)(?: +2)? *$", printed, re.MULTILINE)  # pandas: of 2 runs
    numbers = sorted(map(float, last))
    assert numbers == sorted(rates.values()), f"{numbers}, {rates}\n{printed}"


def load_runs_in_pandas(folder):
    need_module("pandas")
    tables = exported(folder)
    same_rates(call(sys.executable, EXAMPLES / "load_runs.py", tables), tables)
    import pandas

    for file in sorted(tables.glob("*.csv")):
        frame = pandas.read_csv(file)
        for column in frame.select_dtypes("object"):  # texts are missing only where the file is empty
            empty = sum(1 for row in csv.DictReader(open(file)) if row[column] == "")
            assert frame[column].isna().sum() == empty, f"{file.name}: {column}"


def load_runs_in_r(folder):
    need(shutil.which("Rscript"), "Rscript")
    tables = exported(folder)
    same_rates(call("Rscript", EXAMPLES / "load_runs.R", tables), tables)


def convert_charts_to_pdf(folder):
    need(shutil.which("rsvg-convert"), "rsvg-convert, of Debian's librsvg2-bin")
    exported(folder)
    charts = sorted((folder / "mine").rglob("*.svg"))
    assert charts
    for chart in charts:
        call("rsvg-convert", "-f", "pdf", chart, "-o", folder / "chart.pdf")
        pdf = (folder / "chart.pdf").read_bytes()
        width, height = re.search(r'width="(\d+)" height="(\d+)"', chart.read_text()).groups()
        box = [float(n) for n in re.search(rb"/MediaBox \[ ?([\d. ]+)\]", pdf).group(1).split()]
        assert pdf.startswith(b"%PDF") and b"/FontFile" in pdf, f"{chart}: no PDF with its fonts"
        ratio = box[2] / box[3] / (float(width) / float(height))
        assert abs(ratio - 1) < 0.01, f"{chart}: {box} of {width} x {height}"


def run_in_opti_profiler(folder):
    need_module("optiprofiler")
    # Without LaTeX, which OptiProfiler would call for its charts.
    call(sys.executable, EXAMPLES / "optiprofiler/two_solvers.py", cwd=folder, env={**os.environ, "PATH": ""})
    assert list(folder.rglob("summary*.pdf"))
    sys.path.insert(0, str(EXAMPLES / "optiprofiler/ricochet"))
    import ricochet
    import ricochet_tools

    everything = ricochet_tools.ricochet_select({"ptype": "ubln"})
    assert everything == ricochet.problems()
    constrained = ricochet_tools.ricochet_select({"ptype": "n", "maxdim": 4})
    assert "hs-71" in constrained and "count-C1" not in constrained
    hs71 = ricochet_tools.ricochet_load("hs-71")
    assert hs71.fun([1, 5, 5, 1]) == 16 and list(hs71.ceq([1, 5, 5, 1])) == [12] and list(hs71.cub([1, 5, 5, 1])) == [0]


def run_in_the_form_of_coco(folder):
    need_module("numpy")
    printed = call(sys.executable, EXAMPLES / "coco_style.py", folder / "results").splitlines()
    assert len(printed) == 6 and all(line.endswith(" after 50 evaluations") for line in printed)
    rows = list(csv.DictReader(open(folder / "results/improvements.csv")))
    for line in printed:
        name, best = re.match(r"(\S+): (\S+) ", line).groups()
        values = [float(row["objective"]) for row in rows if row["problem"] == name]
        assert values == sorted(values, reverse=True) and f"{values[-1]:g}" == best, line


def run_in_iohexperimenter(folder):
    need_module("ioh")
    printed = call(sys.executable, EXAMPLES / "ioh_style.py", folder)
    assert len(printed.splitlines()) == 2, printed
    assert list(folder.rglob("*.json"))


def main():
    name = re.sub(r"(?<!^)(?=[A-Z])", "_", sys.argv[1]).lower()
    with tempfile.TemporaryDirectory() as folder:
        globals()[name](pathlib.Path(folder))


if __name__ == "__main__":
    main()
