#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "tests/report/site/stated.h"

/// What README and the documents say of solvers, of the surrogate and of the proof is what their
/// reports computed; and no document has a result that is neither in a report nor dated.
namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// How a solver does on a family, in a formulation.
Row runs_of(const Committed& comparison, const std::string& family, const std::string& solver,
            const std::string& formulation) {
  return comparison.row("speed-accuracy", [&](const Row& row) {
    return row.text("family") == family && row.text("solver") == solver &&
           row.text("formulation") == formulation && row.is("largest");
  });
}

/// The first of a family with the largest budget.
Row leader_of(const Committed& comparison, const std::string& family) {
  return comparison.row(
      "leaders", [&](const Row& row) { return row.text("family") == family && row.is("largest"); });
}

/// On all families that most solvers take.
Row on_all(const Committed& comparison, const std::string& solver) {
  return runs_of(comparison, "all", solver, "the best of each");
}

std::string share(const Row& row) {
  return fmt::format("{:.0f} %", 100 * row.number("share"));
}

std::string ends(const Row& row, const char* between) {
  return fmt::format("{:.0f}{}{:.0f}", 100 * row.number("lower"), between,
                     100 * row.number("upper"));
}

/// What both say of the paper's algorithm beside random search.
std::string fireworks_and_random_search(const Committed& comparison, const char* form) {
  const Row own = on_all(comparison, "fireworks"), drawn = on_all(comparison, "random-search");
  return fmt::format(fmt::runtime(form), share(own), ends(own, " to "), share(drawn),
                     ends(drawn, " to "));
}

TEST(StatedResults, OfReadmeAreThoseOfTheComparison) {
  const Committed comparison("comparison");
  Prose readme = part_of("README.md", "**What is the paper's fireworks", "## Two commands");
  readme.states(fireworks_and_random_search(
      comparison, "solves {} of its runs (95 % interval {} %), random search {} ({} %)"));
  const Row strategy = on_all(comparison, "pagmo-cmaes");
  readme.states(fmt::format("CMA-ES (`pagmo-cmaes`) {} ({} %), on the {:.0f} problems",
                            share(strategy), ends(strategy, " to "), strategy.number("problems")));
  readme.states(
      "with 100 evaluations a variable, 1000 up to two variables, or 20 beyond 15 variables");
  const Row fireworks = runs_of(comparison, "top-speed", "fireworks", "count");
  const Row drawn = runs_of(comparison, "top-speed", "random-search", "count");
  const Row bisection = runs_of(comparison, "top-speed", "bisection", "count");
  EXPECT_EQ(bisection.number("share"), 1);
  readme.states(fmt::format(
      "in {} of its runs on {:.0f} problems, random search in {}; bisection in all, in {:.0f} "
      "evaluations on average",
      share(fireworks), fireworks.number("problems"), share(drawn),
      bisection.number("evaluations")));

  // Each row of the table: what is asked, and the row of the comparison that answers it.
  struct First {
    const char *asked, *family, *subset = "";
  };
  const auto shown = [](const std::string& entry, std::optional<double> solved,
                        std::optional<double> best) {
    const std::string sure = best ? fmt::format("{:.2f}", *best) : "";
    return solved ? fmt::format("{} | {:.0f} % | {}", entry, 100 * *solved, sure)
                  : fmt::format("{} | | ", entry);
  };
  for (const First& first :
       {First{"top speed in the window, 1 variable", "top-speed"},
        First{"the same, quiet again far beyond", "hard-top-speed"},
        First{"speed profile of least count, 4 knots", "profile-count", "4 variables"},
        First{"the same, 8 knots", "profile-count", "8 variables"},
        First{"the same, 16 to 64 knots", "profile-count-many"},
        First{"speed profile of least wear, 2 knots", "profile-wear-two"},
        First{"the same, 4 and 8 knots", "profile-wear"},
        First{"the same, 16 to 64 knots", "profile-wear-many"},
        First{"design, 5 variables", "design-count"},
        First{"Hock and Schittkowski's, 2 variables", "hs-two"},
        First{"the same, 3 and 4 variables", "hs", "3 to 4 variables"},
        First{"the same, 5 to 8 variables", "hs", "5 to 8 variables"},
        First{"the same, 9 to 15 variables", "hs", "9 to 15 variables"},
        First{"least squares, 3 to 12 variables", "least-squares", "from the published start"},
        First{"the same, from 10 times the start", "least-squares", "from 10 times the start"},
        First{"the same, from 100 times the start", "least-squares", "from 100 times the start"}}) {
    const bool whole = *first.subset == '\0';
    const Row row =
        whole ? leader_of(comparison, first.family)
              : comparison.row("subsets", [&](const Row& one) {
                  return one.text("family") == first.family && one.text("subset") == first.subset;
                });
    readme.states(
        fmt::format("| {} | {} | {} | {:.0f} ({:.0f}) |", first.asked,
                    shown(row.text("first") + row.text("tuned"), row.number_if("returned"),
                          row.number_if("best")),
                    shown(row.text("differences_first"), row.number_if("differences_returned"),
                          row.number_if("differences_best")),
                    row.number("problems"), row.number("clusters")));
  }
  readme.states("with 100 evaluations a variable, 1000 up to two variables and 20 from 16 on");
  readme.states("near 1, other problems");
  EXPECT_EQ(readme.numbers_left(), "");
  Prose first_lines = part_of("README.md", "# ricochet", "## What we found");
  first_lines.states(fmt::format("to benchmark {:.0f} solvers", comparison.value("solvers")));
  first_lines.states("432 in all");  // see the test of the catalogue
  first_lines.states("(2024)");
  EXPECT_EQ(first_lines.numbers_left(), "");
}

TEST(StatedResults, OfTheFireworksAlgorithmAreThoseOfTheComparison) {
  const Committed comparison("comparison");
  Prose paper =
      part_of("docs/paper.md", "The paper optimises with the fireworks", "LoTFWA's authors");
  paper.states(fireworks_and_random_search(
      comparison, "{} of the runs (95 % interval {} %) against {} ({} %)"));
  const Row strategy = on_all(comparison, "pagmo-cmaes");
  const Row simplex = on_all(comparison, "nlopt-nelder-mead");
  paper.states(
      fmt::format("on {:.0f} problems, each in its best formulation, with 100 evaluations "
                  "a variable up to 15 variables (1000 up to two) and 20 beyond",
                  strategy.number("problems")));
  paper.states(fmt::format("(`pagmo-cmaes`) solves {} ({} %), Nelder and Mead's method {} ({} %)",
                           share(strategy), ends(strategy, " to "), share(simplex),
                           ends(simplex, " to ")));
  const Row fireworks = runs_of(comparison, "top-speed", "fireworks", "count");
  paper.states(fmt::format(
      "it solves {} of its runs, random search {}, and bisection all, on {:.0f} problems",
      share(fireworks), share(runs_of(comparison, "top-speed", "random-search", "count")),
      fireworks.number("problems")));
  const Committed family("fireworks");
  const std::string finding = family.text("finding");
  EXPECT_TRUE(finding.find("gives 7 of the 9 means published") != std::string::npos) << finding;
  EXPECT_TRUE(finding.find("Of 24 means of its successors, 22 agree") != std::string::npos)
      << finding;
  paper.states("of 24 means of four successors, 22 agree");
  paper.states(
      fmt::format("at {:.0f} or further from it, it ends more than {:.0f} times as far away",
                  family.value("far"), family.value("much")));
  paper.states("means are 0 to six decimals");
  paper.states("(Tan and Zhu, 2010)");
  paper.states("equation (24)");
  EXPECT_EQ(paper.numbers_left(), "");

  Prose fitted = part_of("docs/paper.md", "Every other command uses one", "## How close can");
  const Committed calibration("calibration");
  const std::string chosen = calibration.text("interpretation");
  const Row searches = calibration.row("searches", chosen);
  EXPECT_EQ(searches.number("as_good"), 6);
  fitted.states("all six searches end within 1 % of each other");
  EXPECT_EQ(calibration.value("determined"), 4);
  const Committed cases("reproduction");
  for (const auto& [key, named, unit, scale] :
       {std::tuple{"centrifugal_mass_radius", "centrifugal mass radius", "kg m", 1.0},
        std::tuple{"clearance", "clearance", "mm", 1e3},
        std::tuple{"start_velocity", "start velocity", "m/s", 1.0},
        std::tuple{"revolutions", "window", "revolutions", 1.0},
        std::tuple{"counting_limit", "counting limit", "mm/s", 1e3}})
    fitted.states(fmt::format("| {} | {:.4g} {} | fitted |", named,
                              scale * cases.row("parameters", key).number("value"), unit));
  fitted.states(fmt::format("{:.4g} N, {:.4g} N, the middle of the clearance, 0 rad",
                            cases.row("parameters", "pull").number("value"),
                            cases.row("parameters", "normal_force").number("value")));
  EXPECT_EQ(fitted.numbers_left(), "");
}

TEST(StatedResults, CountProblemsAndKindsAsTheComparisonDoes) {
  const Committed comparison("comparison");
  int problems = 0, kinds = 0, variants = 0, kinds_of_variants = 0, two = 0, many = 0;
  int left_out = 0, joinable = 0;
  each_row(comparison.table("leaders"), [&](const Row& row) {
    if (!row.is("largest")) return;
    const std::string family = row.text("family");
    const auto rated = static_cast<int>(row.number("problems"));
    const auto number = rated + static_cast<int>(row.number("left_out"));
    ++kinds;
    problems += number;
    left_out += number - rated;
    if (family.ends_with("-machines") || family.ends_with("-fidelity")) {
      ++kinds_of_variants;
      variants += number;
    } else if (family != "hs" && family != "hs-two") {
      joinable += rated;
    }
    two += family.ends_with("-two");
    many += family.ends_with("-many");
  });
  const auto pathological =
      static_cast<int>(Committed("comparison/robustness").table("pathological").rows.size());
  EXPECT_EQ(problems + pathological, comparison.value("problems"));
  const auto joined = static_cast<int>(on_all(comparison, "random-search").number("problems"));
  EXPECT_EQ(joined, joinable);
  Prose method = part_of("docs/benchmark-method.md", "**Which number of problems", "```console");
  method.states(fmt::format("takes the {} of up to 100 variables", problems - variants));
  method.states(fmt::format(
      "has {} variants of machines and of the model beside them, and the {} that are pathological: "
      "{} problems",
      variants, pathological, problems + pathological));
  method.states(fmt::format(
      "ranks {} kinds: the {} families, those with two variables and with more than 15 apart where "
      "a family has such ({}, named `-two`, and {}, named `-many`), and {} of the variants",
      kinds, kinds - two - many - kinds_of_variants, two, many, kinds_of_variants));
  method.states(fmt::format("{} problems, which tell nothing, are left out", left_out));
  method.states(
      fmt::format("are {} kinds with {} problems: all that are ranked of the plan "
                  "`reference` but `hs` and `hs-two`",
                  kinds - kinds_of_variants - 2, joined));
  method.states("`list problems` has all 432");  // see the test of the catalogue
  EXPECT_EQ(method.numbers_left(), "");
  double least = 1;
  each_row(comparison.table("held-out"), [&](const Row& row) {
    const Row leader = leader_of(comparison, row.text("family"));
    if (leader.number_if("best").value_or(0) >= 0.9)
      least = std::min(least, row.number("first_stays"));
  });
  Prose(repository_text("docs/benchmark-method.md"))
      .states(fmt::format("in {:.0f} % of the draws or more where P(best) is 0.9 or more",
                          100 * least));
  // Nothing is unsolved in one table and solved in another.
  double unsolved = 0;
  each_row(comparison.table("leaders"),
           [&](const Row& row) { unsolved += row.number_if("unsolved").value_or(0); });
  double silent = 0;
  each_row(comparison.table("silent"), [&](const Row& row) { silent += row.is("unsolved"); });
  EXPECT_EQ(silent, unsolved);
}

/// README and all documents.
std::vector<std::string> documents() {
  std::vector<std::string> files = {"README.md"};
  for (const auto& entry : fs::directory_iterator(fs::path(RICOCHET_SOURCE) / "docs")) {
    if (entry.path().extension() == ".md")
      files.push_back("docs/" + entry.path().filename().string());
  }
  return files;
}

/// What the other documents say, taken out of them.
void state_results(const std::string& file, Prose& document) {
  if (file == "docs/benchmark-method.md") {
    const Committed surrogate("surrogate");
    const auto off = [&](double smoothing) {
      std::vector<double> errors;
      int loud = 0;
      each_row(surrogate.table("bias"), [&](const Row& row) {
        if (row.number("smoothing") != smoothing) return;
        errors.push_back(std::abs(row.number("speed_optimality_gap")));
        loud += !row.is("quiet");
      });
      std::ranges::sort(errors);
      const double median = (errors[errors.size() / 2] + errors[(errors.size() - 1) / 2]) / 2;
      return std::tuple{median, errors.back(), loud, errors.size()};
    };
    const auto [wide, worst, loud, all] = off(0.25);
    document.states(
        fmt::format("At 0.25, the fastest speed that the surrogate calls quiet is wrong "
                    "by {:.2f} rad/s in the median of {} cases, by {:.2f} rad/s at "
                    "worst, and truly loud in {} of {} cases",
                    wide, all, worst, loud, all));
    const auto [narrow, worst_narrow, loud_narrow, same] = off(0.001);
    document.states(fmt::format("at 0.001 by {:.2f} and {:.2f} rad/s, but still truly loud in {}",
                                narrow, worst_narrow, loud_narrow));
  }
  if (file == "docs/threshold-and-regimes.md") {
    const Committed verification("verification");
    const Row all = verification.row("scenes", "all");
    EXPECT_EQ(all.number("wrong_certain"), 0);
    document.states(fmt::format(
        "of {} random and hostile scenes, {:.0f} % of the counts are certain and none of these is "
        "wrong; of the uncertain ones, {} are",
        "60,000", 100 * all.number("certain"), "2,548"));
    EXPECT_EQ(all.number("number"), 60'000);
    EXPECT_EQ(all.number("wrong_uncertain"), 2'548);
    document.states(fmt::format(
        "a \"restitution of 0.1\" really returns {:.3f}",
        Committed("simulators").row("restitution", "hunt-crossley").number("of_a_tenth")));
    document.states(
        fmt::format("a window of {:.2f} turns",
                    Committed("reproduction").row("parameters", "revolutions").number("value")));
  }
  if (file == "docs/machine-files.md") {
    const std::string machine = repository_text("reports/reference/machine/summary.md");
    EXPECT_NE(machine.find("pull of 1.5 times that along the track"), std::string::npos);
    document.states("a lateral pull of 1.5 times the pull along x");
  }
  if (file == "docs/tutorial.md") {
    document.states(error_of_the_fit());
    const Committed calibration("calibration");
    document.states(
        fmt::format("{:.0f} % for a machine that was left out of the fit",
                    100 * calibration.row("left-out", "without its machine").number("error")));
  }
}

TEST(StatedResults, OfTheFrontPageAndItsLikeAreFilledIn) {
  static const std::regex filled("^---[^]*?\\n---\\n|\\{\\{[^}]*\\}\\}|\\[N/m\\^1\\.5\\]");
  for (const char* page : {"front", "machines", "cite"}) {
    const std::string text = repository_text(fmt::format("src/report/site/{}.md", page));
    EXPECT_FALSE(text.empty());
    EXPECT_EQ(Prose(std::regex_replace(text, filled, "")).numbers_left(), "") << page;
  }
  EXPECT_EQ(Prose(std::regex_replace("It is {{a:.2f}} of 3.", filled, "")).numbers_left(), "3 ");
}

TEST(StatedResults, OfHowLongCommandsTakeAreThoseOfTheReports) {
  Prose reports = part_of("docs/reports.md", "| command | report |", "| `run full` |");
  for (const auto& [command, folder] :
       {std::pair{"reproduce", "reproduction"}, std::pair{"surrogate", "surrogate"},
        std::pair{"calibrate --all-interpretations --converge", "calibration"},
        std::pair{"fireworks", "fireworks"}, std::pair{"verify", "verification"},
        std::pair{"simulators", "simulators"}}) {
    const double seconds = Committed(folder).value("made.seconds");
    reports.states(fmt::format("/{}/summary.md) | {} |", folder,
                               seconds < 100 ? fmt::format("{:.0f} s", seconds)
                                             : fmt::format("{:.0f} min", seconds / 60)));
    reports.states(fmt::format("| `{}` | [", command));
  }
}

/// Where a page says how long a command takes.
std::string durations_in(const std::string& markdown) {
  static const std::regex remark(
      "(not run:|\\$ \\./ricochet [^\n#]*#)[^\n]*\\b(second|minute|hour)s?\\b");
  static const std::regex sentence(
      "`[a-z][a-z-]*( "
      "[^`]*)?`[^.`]{0,40}\\b(takes?|took)\\s[^.`]{0,20}\\s(s|seconds?|minutes?|hours?)\\b");
  std::string found;
  for (const std::regex* pattern : {&remark, &sentence}) {
    for (std::sregex_iterator it(markdown.begin(), markdown.end(), *pattern), end; it != end; ++it)
      found += it->str() + "; ";
  }
  return found;
}

TEST(StatedResults, OfHowLongCommandsTakeStandOnOnePage) {
  for (const std::string& file : documents()) {
    if (file == "docs/reports.md") continue;
    EXPECT_EQ(durations_in(repository_text(file)), "") << file;
  }
  EXPECT_NE(durations_in("<!-- not run: some minutes -->"), "");
  EXPECT_NE(durations_in("$ ./ricochet reproduce   # 12 seconds"), "");
  EXPECT_NE(durations_in("Then `reproduce --quick` takes\n3 s."), "");
  EXPECT_EQ(durations_in("`--seconds` is the time after which `run` ends; it takes care"), "");
}

/// A document without what is not of the reference: from a block with a date and a version on, the
/// section under its heading.
std::string undated(const std::string& markdown) {
  static const std::regex code("```[^]*?```"), date("20[0-9]{2}-[0-9]{2}-[0-9]{2}[^)]*version");
  std::istringstream lines(std::regex_replace(markdown, code, ""));
  std::string all, block;
  bool dated = false;
  const auto end_block = [&] {
    dated = dated || std::regex_search(block, date);
    if (!dated) all += block + "\n";
    block.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) end_block();
    if (line.starts_with('#')) dated = false;
    block += line + "\n";
  }
  end_block();
  return all;
}

/// What looks like a result, but is set, defined or an example.
const std::vector<std::string>& definitions(const std::string& file) {
  static const std::map<std::string, std::vector<std::string>> all = {
      {"docs/benchmark-method.md",
       {"(p < 0.05)", "with probability 0.2,", "with probability 0.05 NaN", "| 0.1 ms more"}},
      {"docs/command-line.md", {"a name of version 0.1"}},
      {"docs/glossary.md", {"at most 1.5 times as many"}},
      {"docs/identify.md",
       {"5 % are missing, 5 % are spurious", "a factor of 1.5 may be wrong",
        "+- 0.05 rad or 3 degrees", "and 1 % of all", "speeds of up to 2 % is fitted",
        "Restitution above 0.982 and friction below 0.0001 or above 0.999"}},
      {"docs/simulators.md",
       {"friction is 50 % to 0.5 % below", "turns with 1 to 0.02 rad/s", "is 0.3 to 1e-4",
        "by 1 % of the mean time", "more than 1 % of the mean time apart", "more than 1 % off"}},
      {"docs/machine-files.md",
       {"to 0.001 rad/s", "at 1.5 s", "| > 0 | 0.001 |", "| 0.003, 0.001 |", "| 1.5; 1 for",
        "of 0.999999 or less"}},
      {"docs/other-languages.md",
       {"The wheel has 2.2 MB", "Python 3.9 or newer (tried: 3.11)", "glibc 2.35", "Ubuntu 22.04"}},
      {"docs/plans-and-clusters.md", {"16 of 24 planned", "shard 2 of 3", "some 0.4 kB for a run"}},
      {"docs/security.md", {"0.9^20 = 12 %"}},
      {"docs/threshold-and-regimes.md",
       {"uncertain by 5 %", "at most 1.5 times", "(0.01 rad/s in the long run, 0.001 in the window",
        "between 1.1 and 2", "narrower than 2 % of the speed", "within 2 % of 1 rad/s",
        "at most 3 % apart (1 % where phases count differently)", "down to steps of 0.1 %",
        "less than 1 % apart", "1.44, 2.87, 5, 10 and 17 rad/s"}},
      {"docs/tutorial.md",
       {"1.40 and 1.30 kg", "0.5 to 0.7 mm", "9.81 m/s²", "1.35 kg", "1.2 N at 60°", "√(9.81 m/s²",
        "| 6.4 mm |", "first loud speed is 12.666 rad/s"}},
  };
  static const std::vector<std::string> none;
  const auto found = all.find(file);
  return found == all.end() ? none : found->second;
}

/// Parts of which other tests take every number.
std::string without_tested_parts(const std::string& file, std::string text) {
  static const std::vector<std::array<const char*, 3>> parts = {
      {"README.md", "# ricochet", "## Two commands"},
      {"docs/benchmark-method.md", "**Which number of problems", "```console"},
      {"docs/paper.md", "## Are the thresholds real?", "## Which border of"},
      {"docs/paper.md", "### The borders of the machine", "## Which interpretation of"},
      {"docs/paper.md", "Every other command uses one", "LoTFWA's authors"},
      {"docs/threshold-and-regimes.md", "## Why is there a threshold?",
       "## When is a count certain?"},
      {"docs/threshold-and-regimes.md", "That is the machine of the paper's cases C1 and C2",
       "The map has"}};
  for (const auto& [of, from, to] : parts) {
    if (of != file) continue;
    const std::size_t start = text.find(from), end = text.find(to, start);
    if (start == std::string::npos || end == std::string::npos) throw std::logic_error(from);
    text.erase(start, end - start);
  }
  return text;
}

TEST(StatedResults, OfEveryDocumentAreOfTheReferenceOrDated) {
  EXPECT_GT(documents().size(), 15U);
  for (const std::string& file : documents()) {
    Prose document(undated(without_tested_parts(file, repository_text(file))));
    state_results(file, document);
    for (const std::string& definition : definitions(file)) document.states(definition);
    EXPECT_EQ(document.figures_left(), "") << file;
  }
}

TEST(StatedResults, ThatAreNeitherOfTheReferenceNorDatedAreFound) {
  const auto left = [](const char* text) { return Prose(undated(text)).figures_left(); };
  EXPECT_EQ(left("# A\n\nIt is 95 % sure, `7 %`, [a](4.5.md), 1e-6, NLopt 2.7.1, C1, 12.\n"), "");
  EXPECT_EQ(left("# A\n\nIt solves 7 %\nof 3 of 4, by 1.5.\n"), "7 % 3 of 4 1.5 ");
  EXPECT_EQ(left("# A\n\nOf 7 % (2026-11-25, version 0.2.0).\n\n| 8.5 |\n\n# B\n\n9.5\n"), "9.5 ");
}

}  // namespace
}  // namespace ricochet::site
