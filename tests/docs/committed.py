"""What is committed: documents and the data of the reference reports, for the tests of what they say."""
import functools
import json
import pathlib

SOURCE = pathlib.Path(__file__).resolve().parents[2]
REFERENCE = SOURCE / "reports" / "reference"


def text(file):
    return (SOURCE / file).read_text()


def documents():
    """README and all documents, by name."""
    return ["README.md", *sorted(f"docs/{file.name}" for file in (SOURCE / "docs").glob("*.md"))]


@functools.cache
def data(report):
    return json.loads((REFERENCE / report / "data.json").read_text())


def records(table):
    names = [column["name"] for column in table["columns"]]
    return [dict(zip(names, row)) for row in table["rows"]]


def rows(report, table):
    return records(data(report)["tables"][table])


def row(report, table, which):
    """The row whose first column is this, or that has all of these: a=b&c=d. Raises KeyError if there is none."""
    for one in rows(report, table):
        wanted = dict(part.split("=") for part in which.split("&")) if "=" in which else {next(iter(one)): which}
        if all(shown(one[column]) == value for column, value in wanted.items()):
            return one
    raise KeyError(f"{report}: {table} has no row {which}")


def shown(value, form=""):
    """A value as a page has it, by a format of ricochet's tables."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if value is None or isinstance(value, str):
        return value or ""
    if form.endswith("%"):
        return format(100 * value, form[:-1] + "f")
    if form.endswith("m"):
        return format(1000 * value, form[:-1])
    return format(value, form or ("d" if isinstance(value, int) else ".4g"))
