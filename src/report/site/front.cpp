#include "src/report/site/front.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "embedded/citation.h"
#include "embedded/live_default_machine.h"
#include "embedded/live_look.h"
#include "embedded/live_machine.h"
#include "embedded/live_module.h"
#include "embedded/live_scripts.h"
#include "embedded/live_template.h"
#include "embedded/look.h"
#include "embedded/machine_sketch.h"
#include "embedded/page_cite.h"
#include "embedded/page_front.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/report/text.h"

namespace ricochet::site {

namespace {

using report::Results;

/// Adds what a report says under the name of its kind.
void add_report(const FoundReport& found, Results& site) {
  const std::string& kind = found.kind.name;
  if (!found.results) return;
  for (const auto& [name, value] : found.results->values) {
    if (!name.starts_with("made.")) site.values.emplace_back(kind + "." + name, value);
  }
  for (ricochet::Table table : found.results->tables) {
    table.name = kind + "-" + table.name;
    site.add(std::move(table));
  }
  for (report::Chart chart : found.results->charts) {
    chart.name = kind + "-" + chart.name;
    site.add(std::move(chart));
  }
}

constexpr const char* other_version = "Its data are of another version.";

std::string bibtex(const std::string& year) {
  return fmt::format(
      "@software{{ricochet,\n"
      "  title   = {{ricochet}},\n"
      "  author  = {{{{The ricochet authors}}}},\n"
      "  version = {{{}}},\n"
      "{}"
      "  note    = {{Simulates a yarn carrier of a braiding machine and benchmarks solvers on "
      "it}}\n"
      "}}\n\n"
      "@misc{{yao2024,\n"
      "  title        = {{Optimization analysis of carrier-track collision in braiding process}},\n"
      "  author       = {{Yao, Lingling and Song, Wei and Pan, Wei and Lu, Yapeng}},\n"
      "  howpublished = {{De Gruyter, published 2 December 2024}},\n"
      "  year         = {{2024}}\n"
      "}}",
      RICOCHET_VERSION, year.empty() ? "" : fmt::format("  year    = {{{}}},\n", year));
}

/// Which reports this machine has computed, where others are of the reference.
std::string origins_of(const std::vector<FoundReport>& reports) {
  std::vector<std::string> own;
  std::set<std::string> dates;
  for (const FoundReport& report : reports) {
    if (!report.made.reference) own.push_back(label_of(report));
    if (report.made.reference) dates.insert(report.made.date.value_or("an unknown date"));
  }
  if (dates.empty()) return "";
  return fmt::format(
      "Computed on this machine: {}. All else is of the committed reference, computed on {}.",
      own.empty() ? "nothing" : fmt::format("{}", fmt::join(own, "; ")),
      *dates.begin() == *dates.rbegin() ? *dates.begin()
                                        : *dates.begin() + " to " + *dates.rbegin());
}

OwnFiles drawn(const char* source, const Results& results,
               const std::map<std::string, std::string>& pictures = {}) {
  auto [files, failures] = report::page_files(report::page_source(source), results, pictures);
  std::erase_if(files, [](const auto& file) { return file.first.ends_with(".csv"); });
  return {std::move(files), std::move(failures)};
}

}  // namespace

Results site_results(const std::vector<FoundReport>& reports) {
  Results site;
  site.open = true;
  ricochet::Table table{"reports",
                        {{"label"},
                         {"folder"},
                         {"finding"},
                         {"date"},
                         {"command"},
                         {"version"},
                         {"compiler"},
                         {"origin"}}};
  std::string year;
  for (const FoundReport& report : reports) {
    const bool first = std::ranges::none_of(reports, [&](const FoundReport& other) {
      return &other < &report && other.kind.name == report.kind.name;
    });
    if (first) add_report(report, site);
    const Made& made = report.made;
    table.add(label_of(report), report.folder,
              report.headline ? report.headline->finding : other_version, made.date,
              report.headline && !report.headline->command.empty() ? report.headline->command
                                                                   : report.kind.command,
              made.version, made.compiler, made.reference ? "of the reference" : "");
    if (made.date) year = std::max(year, made.date->substr(0, 4));
  }
  if (const std::string told = origins_of(reports); !told.empty()) site.set("origins", told);
  ricochet::Table missing{"missing", {{"label"}, {"command"}, {"question"}}};
  for (const report::ReportKind& kind : report::report_kinds()) {
    const bool there = std::ranges::any_of(
        reports, [&](const FoundReport& report) { return report.kind.name == kind.name; });
    if (!there) missing.add(kind.label, kind.command, kind.question);
  }
  site.add(std::move(table));
  site.add(std::move(missing));
  site.set("bibtex", bibtex(year));
  site.set("citation", embedded::citation);
  return site;
}

OwnFiles front_page(const Results& site) {
  OwnFiles page = drawn(embedded::page_front, site, {{"machine-sketch", embedded::machine_sketch}});
  Results own;  // what the page has of its own
  own.add(*site.table("reports"));
  own.add(*site.table("missing"));
  report::Json data = {{"report", "site"}};
  data.update(json_of(own));
  page.files["data.json"] = report::json_text(data);
  return page;
}

OwnFiles cite_page(const Results& site) {
  return drawn(embedded::page_cite, site);
}

std::string live_page(const std::string& navigation) {
  std::string scripts;
  for (const auto& [name, script] : embedded::live_scripts) scripts += script;
  return report::with_slots(embedded::live_template,
                            {{"navigation", navigation},
                             {"look", embedded::look},
                             {"live_look", embedded::live_look},
                             {"default_machine", embedded::live_default_machine},
                             {"module", embedded::live_module},
                             {"machine_script", embedded::live_machine},
                             {"scripts", scripts}});
}

}  // namespace ricochet::site
