"""The tables of `ricochet export STORE --format csv --out tables` as pandas frames: python3 examples/load_runs.py tables"""

import pathlib
import sys

import pandas

tables = {file.stem: pandas.read_csv(file) for file in pathlib.Path(sys.argv[1]).glob("*.csv")}
runs = tables["runs"].merge(tables["problems"], on="problem")
runs = runs.merge(tables["points"].query("point == 'returned'"), on="number", how="left")
print(runs.groupby(["family", "solver", "formulation", "perturbation"])["returned_solved"].agg(["mean", "size"]))
