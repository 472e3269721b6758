#include "src/report/site/cite_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "embedded/citation.h"
#include "src/report/text.h"

namespace ricochet::site {
namespace {

/// What a comparison says about its runs.
struct Repeated {
  std::optional<std::string> campaign;
  std::int64_t runs;
  std::optional<std::string> digest;
  std::optional<std::int64_t> suite;
};
RICOCHET_READ_FROM_JSON(Repeated, campaign, runs, digest, suite);

/// How a program was built that made a report.
struct Build {
  std::optional<std::string> version, compiler, date;
};
RICOCHET_READ_FROM_JSON(Build, version, compiler, date);

Build build_of(const FoundReport& report) {
  const auto made = report.data.find("made");
  return made == report.data.end() ? Build{} : made->get<Build>();
}

std::string bibtex(const std::vector<FoundReport>& reports) {
  std::string year;
  for (const FoundReport& report : reports) {
    const auto date = build_of(report).date;
    if (date && date->substr(0, 4) > year) year = date->substr(0, 4);
  }
  return fmt::format(
      "@software{{ricochet,\n"
      "  title   = {{ricochet}},\n"
      "  author  = {{{{The ricochet authors}}}},\n"
      "  version = {{{}}},\n"
      "{}"
      "  note    = {{Simulates a yarn carrier of a braiding machine and benchmarks solvers on "
      "it}}\n"
      "}}\n\n"
      "@article{{yao2024,\n"
      "  title     = {{Optimization analysis of carrier-track collision in braiding process}},\n"
      "  author    = {{Yao, Lingling and Song, Wei and Pan, Wei and Lu, Yapeng}},\n"
      "  publisher = {{De Gruyter}},\n"
      "  year      = {{2024}}\n"
      "}}",
      RICOCHET_VERSION, year.empty() ? "" : fmt::format("  year    = {{{}}},\n", year));
}

/// The runs of the largest comparison: how to check and how to repeat them.
report::Section repeat_section(const FoundReport* comparison) {
  report::Section section{.id = "repeat", .heading = "How do I repeat it?"};
  if (comparison == nullptr) {
    section.paragraphs = {"Each report's command is in the table of reports below."};
    return section;
  }
  const auto all = comparison->data.get<Repeated>();
  section.paragraphs = {
      fmt::format(
          "The comparison has {} runs of the plan \"{}\"{}. The seed of a run follows from the "
          "names of problem, formulation, solver, budget, instance and seed, so that each run can "
          "be "
          "repeated alone, bit by bit, on any number of threads.",
          all.runs, all.campaign.value_or("unknown"),
          all.suite ? fmt::format(", version {} of the suite of problems", *all.suite) : ""),
      fmt::format("Digest of all runs, times left out: {}. The archive of the repository, "
                  "reports/archive/reference.archive, has the runs of every solver on every "
                  "problem, without their points; replay repeats runs of it and compares.",
                  all.digest.value_or("unknown"))};
  section.code = {
      fmt::format("./ricochet run {} --out mine      # the same runs; two hours on two cores\n"
                  "./ricochet digest mine             # {}\n"
                  "./ricochet replay reports/archive/reference.archive 1000\n"
                  "./ricochet site --out pages        # these pages, from their data",
                  all.campaign.value_or("plan.toml"), all.digest.value_or("its digest"))};
  return section;
}

report::Table reports_table(const std::vector<FoundReport>& reports) {
  report::Table table{"The reports of this site, and what made them.",
                      {{"report", report::Alignment::left},
                       {"command", report::Alignment::left},
                       {"version", report::Alignment::left},
                       {"compiler", report::Alignment::left},
                       {"date", report::Alignment::left}},
                      {}};
  for (const FoundReport& report : reports) {
    const Build build = build_of(report);
    const bool own = report.headline && !report.headline->command.empty();
    table.rows.push_back({{.text = label_of(report), .link = "../" + report.folder},
                          {own ? report.headline->command : report.kind.command},
                          {build.version.value_or("–")},
                          {build.compiler.value_or("–")},
                          {build.date.value_or("–")}});
  }
  return table;
}

struct Versioned {
  std::string name;
  std::optional<std::string> version;
};
RICOCHET_READ_FROM_JSON(Versioned, name, version);

report::Table solvers_table(const FoundReport& comparison) {
  report::Table table{"Versions of the libraries that the solvers are from.",
                      {{"version", report::Alignment::left}, {"solvers", report::Alignment::left}},
                      {}};
  for (const Json& one : comparison.data.at("solvers")) {
    const auto solver = one.get<Versioned>();
    const std::string version = solver.version.value_or("–");
    const auto same =
        std::ranges::find_if(table.rows, [&](const auto& row) { return row[0].text == version; });
    if (same == table.rows.end()) {
      table.rows.push_back({{version}, {solver.name}});
    } else {
      (*same)[1].text += ", " + solver.name;
    }
  }
  return table;
}

}  // namespace

OwnPage cite_page(const std::vector<FoundReport>& reports, const FoundReport* comparison) {
  OwnPage own{{"Data", "Cite and repeat", "cite"}, {}};
  own.page.title = "Cite and repeat";
  own.page.intro = {
      "Cite the software with its version, and the paper whose machine it simulates. Every report "
      "can be made again by one command; runs repeat bit by bit."};
  own.page.above = "the front page";
  own.page.sections = {
      {.id = "cite", .heading = "How do I cite it?", .code = {bibtex(reports)}},
      repeat_section(comparison),
      {.id = "versions", .heading = "Commands and versions", .tables = {reports_table(reports)}}};
  if (comparison != nullptr) {
    own.page.sections.back().tables.push_back(solvers_table(*comparison));
  }
  own.page.sections.push_back({.id = "citation-file",
                               .heading = "CITATION.cff",
                               .paragraphs = {"The same for programs that read citation files."},
                               .code = {embedded::citation}});
  return own;
}

}  // namespace ricochet::site
