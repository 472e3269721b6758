#!/usr/bin/env python3
"""What README and the documents state is what the committed reports computed, see stated.txt; and no document has a
result that is neither in a report nor dated."""
import math
import pathlib
import re
import statistics
import unittest
from typing import NamedTuple

from committed import data, documents, row, rows, shown, text


class Prose:
    """A text. What is found in it is taken out, so that numbers are left over which nothing states."""

    def __init__(self, markdown):
        self.text = re.sub(r"\s+", " ", re.sub(r"(?s)```.*?```|<!--.*?-->", "", markdown))

    def states(self, sentence):
        """Whether it stands in the text."""
        found = sentence in self.text
        self.text = self.text.replace(sentence, "", 1)
        return found

    def left(self, pattern):
        named = r"`[^`]*`|\]\([^)]*\)|C[0-9]+|[0-9.]+e-?[0-9]+|[0-9]+\.[0-9]+\.[0-9]+"
        rest = re.sub(named, "", self.text).replace("95 %", "")
        return " ".join(found.group() for found in re.finditer(pattern, rest))

    def numbers_left(self):
        """Numbers that are left, but for those of cases and in code and links."""
        return self.left(r"[0-9]+(\.[0-9]+)?")

    def figures_left(self):
        """Numbers that look like results: shares, decimals, "3 of 4", but for 95 %, and powers of ten."""
        return self.left(r"[0-9]+(\.[0-9]+)? %|[0-9]+ of (the )?[0-9]+|[0-9]+\.[0-9]+")


def error_of_the_fit():
    """With its interval: "6 % (95 % interval 3 to 8 %)"."""
    fit = {key: shown(value, ".0%") for key, value in row("calibration", "left-out", "in the fit").items()}
    return f"{fit['error']} % (95 % interval {fit['lower']} to {fit['upper']} %)"


def numbers_of_cases():
    """What is stated of the paper's cases and stands in no report as one number."""
    # Without C11 and C12, of which the paper says nothing.
    cases = {one["case"]: one for one in rows("reproduction", "thresholds")}
    thresholds = [one for case, one in cases.items() if case not in ("C11", "C12")]
    steps = rows("reproduction", "steps")
    of_c = row("reproduction", "conclusions", "C")
    found = {
        "least threshold": min(one["threshold"] for one in thresholds),
        "most threshold": max(one["threshold"] for one in thresholds),
        "worst threshold error": max(abs(one["threshold_error"]) for one in thresholds),
        "same quiet counts": sum(one["paper_quiet_count"] == one["quiet_count"] for one in steps),
        "neighbours of C": of_c["agree"] + of_c["disagree"],
        "rise of C": of_c["strongest"] - 1,
        "error of the fit": error_of_the_fit(),
        "machine page": text("reports/reference/machine/summary.md"),
    }
    for restitution in (0.1, 0.9):
        rises = [one["rise"] for one in steps if cases[one["case"]]["restitution"] == restitution]
        found[f"cases at {restitution}"] = len(rises)
        found[f"steps at {restitution}"] = rises.count("a step")
        found[f"climbs at {restitution}"] = rises.count("a climb")
    return found


def numbers_of_comparison():
    leaders = rows("comparison", "leaders")
    largest = [one for one in leaders if one["largest"]]

    def kinds(*ends):
        return [one for one in largest if one["family"].endswith(ends)]

    def total(families, *columns):
        return sum(one[column] for one in families for column in columns)

    varied, two, many = kinds("-machines", "-fidelity"), kinds("-two"), kinds("-many")
    variants, left_out = total(varied, "problems", "left_out"), total(largest, "left_out")
    plain = total(largest, "problems", "left_out") - variants
    pathological = len(rows("comparison/robustness", "pathological"))
    apart = [one for one in largest if one["family"] in ("hs", "hs-two")]
    sure = [one["family"] for one in largest if (one["best"] or 0) >= 0.9]
    return {
        "problems but variants": plain,
        "variants": variants,
        "pathological": pathological,
        "problems": plain + variants + pathological,
        "kinds": len(largest),
        "families": len(largest) - len(two) - len(many) - len(varied),
        "kinds of two": len(two),
        "kinds of many": len(many),
        "kinds of variants": len(varied),
        "left out": left_out,
        "joined kinds": len(largest) - len(varied) - 2,
        "joined problems": total(largest, "problems") - total(varied + apart, "problems"),
        "unsolved": sum(one["unsolved"] or 0 for one in leaders),
        "unsolved in silence": sum(one["unsolved"] or 0 for one in rows("comparison", "silent")),
        "least first stays": min(one["first_stays"] for one in rows("comparison", "held-out") if one["family"] in sure),
    }


def numbers_of_surrogate():
    found = {}
    for smoothing in (0.25, 0.001):
        bias = [one for one in rows("surrogate", "bias") if one["smoothing"] == smoothing]
        errors = [abs(one["speed_optimality_gap"]) for one in bias]
        found[f"median error at {smoothing}"] = statistics.median(errors)
        found[f"worst error at {smoothing}"] = max(errors)
        found[f"loud at {smoothing}"] = sum(not one["quiet"] for one in bias)
        found[f"cases at {smoothing}"] = len(bias)
    return found


def first_of(family, subset=""):
    """The first of a family with the largest budget, or of a part of it, as the table of README has it."""
    table, part = ("subsets", f"subset={subset}") if subset else ("leaders", "largest=yes")
    one = row("comparison", table, f"family={family}&{part}")

    def entry(name, of):
        solved, best = one[of + "returned"], one[of + "best"]
        return f"{name or ''} | | " if solved is None else f"{name} | {shown(solved, '.0%')} % | {shown(best, '.2f')}"

    both = entry(one["first"] + (one["tuned"] or ""), ""), entry(one["differences_first"], "differences_")
    return f"{both[0]} | {both[1]} | {one['problems']} ({one['clusters']})"


def point_of(report, chart, curve, position):
    for series in data(report)["charts"][chart]["series"]:
        if series["label"].startswith(curve):
            return next(y for x, y, *_ in series["samples"] if abs(x - position) < 1e-9)
    raise KeyError(curve)


class Section(NamedTuple):
    """A part of a file, or with empty ends what no part has, and the lines about it."""

    file: str
    begin: str
    end: str
    lines: list

    def place(self, markdown):
        start = markdown.index(self.begin)
        return start, markdown.index(self.end, start)


class Stated:
    """stated.txt."""

    def __init__(self):
        self.computed = {**numbers_of_cases(), **numbers_of_comparison(), **numbers_of_surrogate()}
        self.names, self.sections = {}, []
        for line in pathlib.Path(__file__).with_name("stated.txt").read_text().splitlines():
            if line in ("", "#") or line.startswith("# "):
                continue
            if found := re.fullmatch(r"let (.*?) = (.*)", line):
                self.names[found[1]] = found[2]
            elif found := re.fullmatch(r"= ([^:]*)(?:: (.*) -> (.*))?", line):
                self.sections.append(Section(found[1], found[2] or "", found[3] or "", []))
            else:
                self.sections[-1].lines.append(line)

    def value(self, path):
        if path in self.computed:
            return self.computed[path]
        name, *rest = path.split("/")
        parts = [*self.names.get(name, name).split("/"), *rest]
        if parts[0] == "first":
            return first_of(*parts[1:])
        if len(parts) == 4 and parts[3].startswith("@"):
            return point_of(*parts[:3], float(parts[3][1:]))
        if len(parts) == 4:
            return row(*parts[:3])[parts[3]]
        report, name = parts
        return data(report)["made"][name[5:]] if name.startswith("made.") else data(report)["values"][name]

    def shown(self, path, form):
        value = self.value(path)
        if form == "or -":
            return shown(value) or "-"
        assert value is not None, f"{path} is missing"
        if form == "rpm":
            return f"{value * 30 / math.pi:.0f}"
        if form == "time":
            return f"{value:.0f} s" if value < 100 else f"{value / 60:.0f} min"
        return shown(value, form)

    def filled(self, line):
        """The line with its slots filled in, the innermost first."""
        while found := re.search(r"\{([^{}:]*)(?::([^{}]*))?\}", line):
            line = line[: found.start()] + self.shown(found[1], found[2] or "") + line[found.end() :]
        return line

    def check(self, section, prose):
        """Yields what is wrong with the lines of a section; takes them out of the prose."""
        for line in section.lines:
            if found := re.fullmatch(r"given (.*) (=|has) (.*)", line):
                one, other = self.filled(found[1]), self.filled(found[3])
                if not (one == other if found[2] == "=" else other in one):
                    yield f"{line}: {one}"
            elif found := re.fullmatch(r"each ([^:]*): (.*)", line):
                for one in rows(*found[1].split("/")):
                    self.names["row"] = f"{found[1]}/{next(iter(one.values()))}"
                    yield from self.check(Section("", "", "", [found[2]]), prose)
            elif not prose.states(self.filled(line)):
                yield f"not stated: {self.filled(line)}"


def undated(markdown):
    """A document without what is not of the reference: from a block with a date and a version on, the section under
    its heading."""
    kept, dated = "", False
    for block in re.split(r"\n\n|\n(?=#)", re.sub(r"(?s)```.*?```", "", markdown)):
        dated = (dated and not block.startswith("#")) or bool(re.search(r"20\d\d-\d\d-\d\d[^)]*version", block))
        kept += "" if dated else block + "\n\n"
    return kept


def durations_in(markdown):
    """Where a page says how long a command takes."""
    remark = r"(?:not run:|\$ \./ricochet [^\n#]*#)[^\n]*\b(?:second|minute|hour)s?\b"
    sentence = r"`[a-z][a-z-]*(?: [^`]*)?`[^.`]{0,40}\b(?:takes?|took)\s[^.`]{0,20}\s(?:s|seconds?|minutes?|hours?)\b"
    return re.findall(remark, markdown) + re.findall(sentence, markdown)


class StatedResults(unittest.TestCase):
    def test_of_parts_are_those_of_the_reports(self):
        stated = Stated()
        parts = [section for section in stated.sections if section.begin]
        self.assertEqual(len(parts), 10)
        for section in parts:
            with self.subTest(f"{section.file}: {section.begin}"):
                markdown = text(section.file)
                start, end = section.place(markdown)
                prose = Prose(markdown[start:end])
                self.assertEqual(list(stated.check(section, prose)), [])
                self.assertEqual(prose.numbers_left(), "")

    def test_of_every_document_are_of_the_reference_or_dated(self):
        stated = Stated()
        self.assertGreater(len(documents()), 15)
        self.assertLessEqual({section.file for section in stated.sections}, set(documents()))
        for file in documents():
            with self.subTest(file):
                markdown, rest = text(file), []
                for section in (one for one in stated.sections if one.file == file):
                    if section.begin:
                        start, end = section.place(markdown)
                        markdown = markdown[:start] + markdown[end:]
                    else:
                        rest.append(section)
                prose = Prose(undated(markdown))
                self.assertEqual([wrong for section in rest for wrong in stated.check(section, prose)], [])
                self.assertEqual(prose.figures_left(), "")

    def test_that_are_neither_of_the_reference_nor_dated_are_found(self):
        document = Prose("C1 at 8.08\nrad/s, `7`, [3](4.md) and 5.")
        self.assertTrue(document.states("at 8.08 rad/s"))
        self.assertEqual(document.numbers_left(), "3 5")
        for markdown, left in (
            ("# A\n\nIt is 95 % sure, `7 %`, [a](4.5.md), 1e-6, NLopt 2.7.1, C1, 12.\n", ""),
            ("# A\n\nIt solves 7 %\nof 3 of 4, by 1.5.\n", "7 % 3 of 4 1.5"),
            ("# A\n\nOf 7 % (2026-11-25, version 0.2.0).\n\n| 8.5 |\n\n# B\n\n9.5\n", "9.5"),
        ):
            self.assertEqual(Prose(undated(markdown)).figures_left(), left)

    def test_of_the_front_page_and_its_like_are_filled_in(self):
        def left(markdown):
            return Prose(re.sub(r"(?s)^---.*?\n---\n|\{\{[^}]*\}\}|\[N/m\^1\.5\]", "", markdown)).numbers_left()

        for page in ("front", "machines", "cite"):
            self.assertEqual(left(text(f"src/report/site/{page}.md")), "", page)
        self.assertEqual(left("It is {{a:.2f}} of 3."), "3")

    def test_in_words_hold_in_the_reports(self):
        threshold = {one["case"]: one["threshold"] for one in rows("reproduction", "thresholds")}
        self.assertGreaterEqual(threshold["C9"], threshold["C1"], "the paper's fall")
        self.assertGreater(3.6, threshold["C10"], "Figure 13 with restitution 0.9")
        values = data("reproduction")["values"]
        self.assertAlmostEqual(values["formula.error"], values["error"], delta=0.005)
        exponents = {one["constant"]: one for one in rows("reproduction", "exponents")}
        for case in ("C1", "C2", "C3", "C4"):
            limit, restitution, clearance, friction = (
                exponents[name][case] for name in ("counting limit", "restitution", "clearance", "friction")
            )
            self.assertAlmostEqual(limit + restitution, 0, delta=0.03)
            self.assertGreater(limit, max(0.3, abs(clearance)))
            self.assertLess(max(restitution, clearance), 0)
            self.assertGreater(friction, 0)

    def test_of_the_fit_have_their_interval_wherever_they_stand(self):
        whole = error_of_the_fit()
        error, interval = whole.split(" (", 1)

        def bare(markdown):
            """But for the error of the formula of one line, which is not that of the fit."""
            return re.findall(f"(?<!misses them by )(?<![0-9.]){error}(?! {re.escape('(' + interval)})", markdown)

        for file in ("README.md", "docs/paper.md", "docs/tutorial.md", "reports/reference/summary.md",
                     "reports/reference/reproduction/summary.md"):  # fmt: skip
            markdown = re.sub(r"\s+", " ", text(file))
            self.assertIn(whole, markdown, file)
            self.assertEqual(bare(markdown), [], f"{file}: without its interval")
        self.assertEqual(bare(f"1{error} 0.{error} {whole} misses them by {error}"), [])
        self.assertEqual(bare(f"{whole}, {error} b"), [error])

    def test_of_how_long_commands_take_stand_on_one_page(self):
        for file in documents():
            if file != "docs/reports.md":
                self.assertEqual(durations_in(text(file)), [], file)
        for wrong in ("<!-- not run: some minutes -->", "$ ./ricochet reproduce   # 12 seconds",
                      "Then `reproduce --quick` takes\n3 s."):  # fmt: skip
            self.assertEqual(len(durations_in(wrong)), 1, wrong)
        self.assertEqual(durations_in("`--seconds` is the time after which `run` ends; it takes care"), [])


if __name__ == "__main__":
    unittest.main()
