#!/usr/bin/env python3
"""What is committed of the reference report, and of Markdown: small, whole, and the same in several places; every
number of a page stands in the data beside it, or in the template's own words. Without git some tests are skipped."""
import bisect
import re
import subprocess
import unittest

from committed import REFERENCE, SOURCE, data, records, text

REPORTS = sorted(str(file.parent.relative_to(REFERENCE)) for file in REFERENCE.rglob("data.json"))
PAGES = sorted(str(file.relative_to(SOURCE)) for file in REFERENCE.rglob("summary.md"))
COMPARISON = [report for report in REPORTS if report.split("/")[0] == "comparison"]


def committed_files():
    """What git keeps, or would keep once it is told of what is new; nothing where there is no git."""
    call = ["git", "-C", SOURCE, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        told = subprocess.run(call, capture_output=True, text=True)
    except FileNotFoundError:
        return set()
    return {name for name in told.stdout.split("\0") if name and (SOURCE / name).exists()}


FILES = committed_files()


def template(kind):
    """The source of a page of this kind."""
    return next(SOURCE.glob(f"src/**/{kind}.md")).read_text()


def anchors_in(markdown):
    """The anchors that code hosts make of headings: small letters, digits and hyphens."""
    headings = re.findall(r"(?m)^#+ (.*)", markdown)
    return {re.sub(r"[^\w -]", "", heading).lower().replace(" ", "-") for heading in headings}


def dead_links(files, name, markdown):
    """The links and pictures of a file that lead to nothing that is committed, but for those to other sites and in
    code."""
    dead = []
    prose = re.sub(r"(?s)```.*?```|`[^`\n]*`", "", markdown)
    for file, anchor in re.findall(r"\]\((?![a-z]+:)([^)\s#]*)(?:#([^)\s]*))?\)", prose):
        steps = name.split("/")[:-1] if file else name.split("/")
        for step in (step for step in file.split("/") if step not in ("", ".")):
            steps = steps[:-1] if step == ".." else [*steps, step]
        target = "/".join(steps)
        there = target in files or any(other.startswith(target + "/") for other in files)
        if there and anchor:
            there = target.endswith(".md") and anchor in anchors_in(markdown if target == name else text(target))
        if not there:
            dead.append(f"{file}#{anchor}" if anchor else file)
    return dead


@unittest.skipUnless(FILES, "no git, or no repository")
class Reference(unittest.TestCase):
    def test_stays_small(self):
        size = sum((SOURCE / name).stat().st_size for name in FILES if name.startswith("reports/reference/"))
        self.assertGreater(size, 1_000_000)
        self.assertLess(size, 5_600_000)

    def test_has_the_data_of_every_page_and_says_at_its_foot_how_it_was_made(self):
        foot = (r"\nMade on 20[0-9]{2}-[0-9]{2}-[0-9]{2} by ricochet [0-9.]+ \(.+\) in [0-9.]+ s, with [0-9]+ threads?"
                r"( on .+)?\.\n\Z")  # fmt: skip
        self.assertGreater(len(REPORTS), 15)
        for page in PAGES:
            folder = page.removesuffix("/summary.md")
            # These are drawn from the data of all others.
            if folder in ("reports/reference", "reports/reference/machine", "reports/reference/cite"):
                continue
            self.assertIn(f"{folder}/data.json", FILES)
            self.assertRegex(text(page), foot, page)

    def test_has_links_that_lead_somewhere_on_a_code_host(self):
        outside = [name for name in sorted(FILES) if "/" not in name or name.startswith(("docs/", "reports/reference/"))]
        pages = [name for name in outside if name.endswith(".md")]
        self.assertGreater(len(pages), 20)
        for name in pages:
            self.assertEqual(dead_links(FILES, name, text(name)), [], name)

    def test_dead_links_are_to_files_folders_and_places_that_are_not_there(self):
        def dead(markdown):
            return dead_links({"a/one.md", "a/b/picture.svg", "CONTRIBUTING.md"}, "a/one.md", markdown)

        self.assertEqual(dead("![p](b/picture.svg) [b](b) [b](b/) [c](../CONTRIBUTING.md) [x](https://x.org)"), [])
        self.assertEqual(dead("# What it *is*: 3 of 4\n[here](#what-it-is-3-of-4), `[code](nowhere)`"), [])
        self.assertEqual(dead("[a](index.html) [b](b/summary.md#there) [c](#nowhere)"),
                         ["index.html", "b/summary.md#there", "#nowhere"])  # fmt: skip


def numbers_in(markdown):
    """The numbers of a text, as they are written. A hyphen between words is no minus."""
    return re.findall(r"[0-9]+(?:\.[0-9]+)?(?:e[-+]?[0-9]+)?", markdown)


class Known:
    """The numbers that may be written."""

    def __init__(self, values, words):
        self.written, self.sizes = set(numbers_in(words)), []
        self.add(values)
        self.sizes.sort()

    def add(self, value):
        if isinstance(value, str):
            self.written.update(numbers_in(value))
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            self.sizes += [abs(value), 100 * abs(value)]  # shares are shown as hundredths
        elif isinstance(value, list):
            self.sizes.append(len(value))
            for one in value:
                self.add(one)
        elif isinstance(value, dict):
            for key, one in value.items():
                self.add(key)
                self.add(one)

    def has(self, number):
        """Whether the number is one of them, rounded to its last digit; signs are left out."""
        mantissa, _, exponent = number.partition("e")
        off = 0.5000001 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
        at = bisect.bisect_left(self.sizes, float(number) - off)
        return number in self.written or (at < len(self.sizes) and self.sizes[at] <= float(number) + off)


def unknown_numbers(page, values, words):
    known = Known(values, words)
    # The escapes and links of Markdown are no numbers that are shown.
    return [number for number in numbers_in(re.sub(r"\]\([^)]*\)|&#[0-9]+;", "]", page)) if not known.has(number)]


# What no reader should find, but for what follows a sign, a point or a hyphen, such as 0.1 turns.
PLURALS = ("borders|cases|collisions|columns|constants|cores|entries|evaluations|families|fits|impacts|instances|kinds"
           "|knots|levels|machines|methods|pages|pairs|parameters|points|problems|regimes|reports|rows|runs|scenes"
           "|searches|seeds|settings|simulations|solvers|speeds|starts|steps|stores|tools|turns|values|variables")  # fmt: skip
WRONG = re.compile(rf"(?<![-0-9.,/_A-Za-z])1 (?:{PLURALS})\b|[0-9] us\b|\bby [-−][0-9]")
TOO_EXACT = re.compile(r"\.[0-9]{13}")


class Numbers(unittest.TestCase):
    def test_of_every_page_stand_in_the_data_beside_it(self):
        for report in REPORTS:
            above = report.rpartition("/")[0]  # says how a further page was made
            values = [data(report), data(above)["made"] if above else None]
            page = text(f"reports/reference/{report}/summary.md")
            self.assertEqual(unknown_numbers(page, values, template(data(report)["report"])), [], report)

    def test_that_are_not_in_the_data_are_found(self):
        def unknown(page):
            values = {"speed": 8.2749, "share": 0.0625, "name": "C12", "cost": -12345.0, "list": ["a", "b", "c"]}
            return unknown_numbers(page, values, "step 0.001")

        self.assertEqual(unknown("8.27 rad/s, 8.275, 6.25 %, 6 %, C12, -1.23e+04, steps of 0.001, 3"), [])
        self.assertEqual(unknown("8.28 rad/s, 7 %, C13, 1.24e+04, 2"), ["8.28", "7", "13", "1.24e+04", "2"])

    def test_are_as_a_reader_writes_them(self):
        for page in PAGES:
            self.assertEqual(WRONG.findall(text(page)) + TOO_EXACT.findall(text(page)), [], page)
        for report in REPORTS:
            self.assertEqual(WRONG.findall(text(f"reports/reference/{report}/data.json")), [], report)

    def test_as_no_reader_writes_them_are_found(self):
        found = WRONG.findall("0.1 turns, 11 runs, 1 run, 1.5 us, by 3, one-1 runs, = 1 turns, by -11, by −0.5")
        self.assertEqual(found, ["5 us", "1 turns", "by -1", "by −0"])
        self.assertEqual(TOO_EXACT.findall("0.0009, 0.0009000000000000001"), [".0009000000000"])

    def test_of_the_window_are_called_by_its_name(self):
        """The fastest quiet speed is of the long run; the comparison's problems ask for another."""
        pages = [page for page in PAGES if page.split("/")[2] in ("comparison", "surrogate")]
        self.assertGreater(len(pages), 10)
        for page in pages:
            self.assertNotIn("astest quiet speed", text(page), page)


def plain(markdown):
    """In small letters, with one blank wherever there are blanks and ends of lines."""
    return re.sub(r"\s+", " ", markdown).lower()


class Glossary(unittest.TestCase):
    lines = [line for line in text("docs/glossary.md").splitlines() if line.startswith("- ")]
    terms = [plain(term) for term in re.findall(r"\n- \*\*([^*]+)\*\*", text("docs/glossary.md"))]

    def test_has_each_term_once_in_the_order_of_the_alphabet(self):
        self.assertGreater(len(self.terms), 50)
        self.assertEqual(self.terms, sorted(set(self.terms)))

    def test_has_only_terms_that_a_page_or_another_document_uses(self):
        places = ("README.md", "docs/**/*.md", "src/studies/**/*.md", "reports/reference/**/summary.md",
                  "reports/templates/**/*.*")  # fmt: skip
        files = [file for place in places for file in SOURCE.glob(place) if file.name != "glossary.md"]
        self.assertGreater(len(files), 50)
        used = " ".join(plain(file.read_text()) for file in files)
        for term in self.terms:  # as words of their own, perhaps in the plural
            self.assertRegex(used, rf"(?<![a-z]){re.escape(term)}s?(?![a-z])")

    def test_says_of_each_term_where_more_is_said(self):
        for line in self.lines:
            entry = re.fullmatch(r"- \*\*[^*]+\*\*( \[[^\]]+\])?: .+\. \[[^\]]+\]\(([^)#]+)(#[^)]*)?\)", line)
            self.assertTrue(entry and (SOURCE / "docs" / entry[2]).exists(), line)


class Comparison(unittest.TestCase):
    """What the committed comparison says of who is first, in several places, is one thing."""

    leaders = records(data("comparison")["tables"]["leaders"])

    def test_has_one_first_and_one_probability_of_each_family(self):
        named = 0
        families = [part for report in COMPARISON for part in data(report).get("parts", {}).get("families", [])]
        for part in (part for part in families if "budgets" in part.get("parts", {})):
            for budget in part["parts"]["budgets"]:
                which = part["id"], float(budget["id"])
                leader = next(one for one in self.leaders if (one["family"], one["budget"]) == which)
                all_ratings = records(budget["tables"]["ratings"])
                ratings = [one for one in all_ratings if one["rank"] is not None]
                first = min(ratings, key=lambda one: one["rank"], default=all_ratings[0])
                self.assertEqual(first["rank"], all_ratings[0]["rank"], "best first")
                if leader["solver"] is None:  # none solves, or random search is enough
                    continue
                named += 1
                for key in ("solver", "formulation", "best", "returned"):
                    self.assertEqual(leader[key], first[key], part["id"])
                # Rates have three digits here: who solves hardly more is named, but looks as good.
                more = [one["returned"] - first["returned"] for one in ratings
                        if (one["solver"], one["formulation"]) != (first["solver"], first["formulation"])]  # fmt: skip
                said = leader["most"] is not None
                self.assertEqual(any(ahead >= 0 if said else ahead > 0 for ahead in more), said,
                                 f"{part['id']}: whoever solves more than the first is named beside it")  # fmt: skip
        self.assertGreater(named, 10)

    def test_says_of_a_solver_where_it_is_first(self):
        firsts = 0
        for solver in records(data("comparison/solvers")["tables"]["solvers"]):
            families = [one["family"] for one in self.leaders if one["largest"] and one["solver"] == solver["solver"]]
            self.assertEqual(solver["first"] or "", ", ".join(families), solver["solver"])
            firsts += len(families)
        self.assertGreater(firsts, 10)

    def test_marks_a_first_that_was_tuned_to_the_suite(self):
        tuned = [one for one in self.leaders if re.fullmatch("continuation-.*(?<!-tuned)", one["solver"] or "")]
        self.assertEqual({one["tuned"] for one in tuned}, {" (tuned to this suite)"})

    def test_promises_no_interval_where_a_chart_has_none(self):
        def without(results, name):
            """The charts of this name, in the results and their parts, that have no interval."""
            chart = results.get("charts", {}).get(name)
            samples = [sample for series in (chart or {}).get("series", []) for sample in series["samples"]]
            own = chart is not None and not any(len(sample) > 3 and sample[2] is not None for sample in samples)
            return own + sum(without(part, name) for parts in results.get("parts", {}).values() for part in parts)

        promises = 0
        for report in COMPARISON:
            for name in re.findall(r"\{\{chart ([a-z-]+)\}\}.*interval", template(data(report)["report"])):
                promises += 1
                self.assertEqual(without(data(report), name), 0, f"{report}: {name}")
        self.assertGreater(promises, 0)

    def test_has_most_runs_fail_on_problems_that_do(self):
        """The page of Robustness says that most runs fail that restart where a problem does in a part of its box, even
        if they solved it before."""
        endings = {one["problem"]: one for one in records(data("comparison/robustness")["tables"]["pathological"])}
        for problem, ending in (("throws", "threw"), ("hangs", "killed"), ("crashes", "crashed")):
            one = endings[f"pathological-{problem}"]
            self.assertGreater(one[ending], 0.5 * one["runs"], problem)
            self.assertGreater(one["found"], one["solved"], problem)

    def test_is_read_in_two_evenings(self):
        words = sum(len(text(page).split()) for page in PAGES if page.split("/")[2] == "comparison")
        self.assertTrue(5_000 < words < 50_000, words)


if __name__ == "__main__":
    unittest.main()
