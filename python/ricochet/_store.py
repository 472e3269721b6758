"""The runs of a campaign's store."""

from __future__ import annotations

import os
import pathlib
import sqlite3
import struct
from typing import TYPE_CHECKING, Any

from ._library import Error

if TYPE_CHECKING:
    import pandas

_APPLICATION = 0x5249434F  # of src/experiment/schema.sql


def runs(path: str | os.PathLike[str]) -> pandas.DataFrame:
    """All runs of a store, such as that of `ricochet compare`, as a pandas frame.

    One row for each run, with the columns of the store's view `result`: what was run (problem,
    formulation, perturbation, solver, budget, gradient_price, instance, run), what it took (charged
    evaluations, seconds of processor time), why it ended, and the best evaluated point's objective
    and violation, found after so many evaluations.

    >>> frame = ricochet.runs("runs.sqlite")
    >>> frame.groupby("solver")["charged"].max()
    solver
    random-search    100
    Name: charged, dtype: int64

    Raises Error if the file is no store. Needs pandas.
    """
    import pandas  # it takes longer to import than all else here

    uri = pathlib.Path(path).absolute().as_uri() + "?mode=ro"
    try:
        connection = sqlite3.connect(uri, uri=True)
        try:
            if connection.execute("PRAGMA application_id").fetchone()[0] != _APPLICATION:
                raise Error(f"{os.fspath(path)}: is no store of ricochet")
            frame = pandas.read_sql_query("SELECT * FROM result", connection, index_col="number")
        finally:
            connection.close()
    except sqlite3.Error as error:
        raise Error(f"{os.fspath(path)}: {error}") from error
    for name in ("seconds", "objective", "violation"):
        frame[name] = frame[name].map(_number).astype(float)
    return frame


def _number(stored: Any) -> Any:
    """A number that SQLite would change is stored as the eight bytes of its double."""
    return struct.unpack("<d", stored)[0] if isinstance(stored, bytes) else stored
