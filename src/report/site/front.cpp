#include "src/report/site/front.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

#include "src/report/site/entries.h"
#include "src/report/site/front_answers.h"

namespace ricochet::site {

namespace {

constexpr const char* other_version = "Its data are of another version: run the command again.";

/// Splits a link in a report's page into the folder and the anchor with its #.
std::pair<std::string, std::string> place_of(const std::string& report, const std::string& to) {
  const std::size_t hash = std::min(to.find('#'), to.size());
  const std::string page = to.substr(0, hash);
  return {page.empty() ? report : report + "/" + page, to.substr(hash)};
}

FrontExcerpt excerpt_of(const report::Excerpt& from, const std::string& folder) {
  FrontExcerpt excerpt{from.heading, from.text, {}, from.table.caption, {}, {}};
  for (const report::Link& link : from.links) {
    const auto [page, anchor] = place_of(folder, link.to);
    excerpt.links.push_back({link.text, page, anchor});
  }
  for (const report::Column& column : from.table.columns) {
    excerpt.columns.push_back({column.title, column.alignment == report::Alignment::left});
  }
  for (const std::vector<report::Cell>& row : from.table.rows) {
    FrontRow& shown = excerpt.rows.emplace_back();
    for (const report::Cell& cell : row) {
      const bool left = excerpt.columns[shown.cells.size()].left;
      const auto [page, anchor] = place_of(folder, cell.link);
      shown.cells.push_back({cell.text, cell.link.empty() ? "" : page, anchor, left});
    }
  }
  return excerpt;
}

void add_excerpts(const report::Headline& headline, const std::string& folder, Front& front) {
  const std::map<std::string, std::vector<FrontExcerpt>*> topics = {{"speed", &front.speed},
                                                                    {"solver", &front.solver},
                                                                    {"question", &front.question},
                                                                    {"entries", &front.entries}};
  for (const report::Excerpt& excerpt : headline.excerpts) {
    const auto topic = topics.find(excerpt.topic);
    if (topic != topics.end()) topic->second->push_back(excerpt_of(excerpt, folder));
  }
}

/// "8.07–8.08", or one number; empty without any.
std::string extent_of(const std::vector<double>& speeds, const char* form) {
  if (speeds.empty()) return "";
  const auto [least, most] = std::ranges::minmax(speeds);
  const std::string first = fmt::format(fmt::runtime(form), least);
  return least == most ? first : first + "–" + fmt::format(fmt::runtime(form), most);
}

/// Adds the speeds of the paper's machines, a row for those that differ in the disturbance alone.
void add_speeds(const PaperMachines& all, Front& front) {
  const auto range = quiet_range(all.machines);
  if (!range) return;
  FrontExcerpt speeds{
      .heading = fmt::format("{:.1f} to {:.1f} rad/s", range->first, range->second),
      .text =
          fmt::format("{:.0f} to {:.0f} rpm. While quiet, no turn of the long run has more than "
                      "two collisions.",
                      range->first * rpm, range->second * rpm),
      .links = {{"the paper's cases", all.folder, ""}},
      .caption = "Fastest quiet speeds [rad/s]",
      .columns = {{"cases", true},
                  {"restitution", false},
                  {"friction", false},
                  {"silent to", false},
                  {"quiet to", false},
                  {"paper", false}}};
  for (std::size_t i = 0; i < all.machines.size();) {
    const PaperMachine& first = all.machines[i];
    std::string ids;
    std::vector<double> silent, quiet, published;
    for (; i < all.machines.size(); ++i) {
      const PaperMachine& one = all.machines[i];
      if (one.restitution != first.restitution || one.friction != first.friction) break;
      ids += (ids.empty() ? "" : ", ") + one.id;
      if (one.silent_up_to) silent.push_back(*one.silent_up_to);
      if (one.quiet_up_to) quiet.push_back(*one.quiet_up_to);
      if (one.paper_threshold) published.push_back(*one.paper_threshold);
    }
    speeds.rows.push_back({{{ids, all.folder, cases_anchor, true},
                            {fmt::format("{}", first.restitution), "", "", false},
                            {fmt::format("{}", first.friction), "", "", false},
                            {extent_of(silent, "{:.2f}"), "", "", false},
                            {extent_of(quiet, "{:.2f}"), "", "", false},
                            {extent_of(published, "{}"), "", "", false}}});
  }
  front.speed.insert(front.speed.begin(), std::move(speeds));
}

/// Adds the ranks of external solvers with the largest budget of each family, and the number of
/// entries.
void add_places(const Comparison& comparison, Front& front) {
  std::map<std::size_t, double> largest;
  for (const Entry& entry : comparison.entries) {
    largest[entry.family] = std::max(largest[entry.family], entry.budget);
  }
  FrontExcerpt places{
      .caption = "Places of solvers from outside",
      .columns = {
          {"solver, formulation", true}, {"problems", true}, {"budget", false}, {"place", false}}};
  for (const Entry& entry : comparison.entries) {
    if (!entry.outside || entry.budget == 0 || entry.budget != largest[entry.family]) continue;
    places.rows.push_back({{{fmt::format("{}, {}", entry.solver, entry.formulation), "", "", true},
                            {comparison.families[entry.family].name, "", "", true},
                            {fmt::format("{}", entry.budget), "", "", false},
                            {fmt::format("{} of {}", entry.place, entry.of), "", "", false}}});
  }
  if (!places.rows.empty()) front.own.push_back(std::move(places));
}

Card card_of(const FoundReport& report) {
  Card card{report.folder,       label_of(report),   report.kind.label,
            other_version,       report.made.date,   report.made.quick.value_or(false),
            report.made.seconds, report.kind.command};
  if (!report.headline) return card;
  card.title = report.headline->title;
  card.finding = report.headline->finding;
  if (!report.headline->command.empty()) {  // linked if it exists
    card.command = report.headline->command;
    card.seconds.reset();
  }
  return card;
}

/// The folder whose data cannot be read: that of a report, or of one of its pages.
std::string unread_folder(const FoundReport& report) {
  for (const FoundPage& page : report.pages) {
    if (!holds(page.headline, "family")) continue;
    try {
      static_cast<void>(page.data.get<FamilyData>());
    } catch (const Json::exception&) {
      return report.folder + "/" + page.folder;
    }
  }
  return report.folder;
}

/// Marks the reports whose data cannot be read.
template <class Read>
auto read_or_mark(const FoundReport* report, Front& front, const Read& read) {
  using Result = std::optional<std::decay_t<decltype(read(*report))>>;
  if (report == nullptr) return Result();
  try {
    return Result(read(*report));
  } catch (const std::exception& error) {  // of another version, or damaged
    front.unread.emplace_back(unread_folder(*report), error.what());
    for (Card& card : front.cards) {
      if (card.folder == report->folder) card.finding = other_version;
    }
    return Result();
  }
}

/// The report of the paper's cases; null if there is none.
const FoundReport* of_kind(const std::vector<FoundReport>& reports, const std::string& kind) {
  const auto found = std::ranges::find_if(reports, [&](const FoundReport& report) {
    return report.kind.name == kind && report.headline;
  });
  return found == reports.end() ? nullptr : &*found;
}

void read_machines(const std::vector<FoundReport>& reports, Front& front) {
  front.machines = read_or_mark(of_kind(reports, "reproduction"), front, [&](const FoundReport&) {
                     return paper_machines(reports);
                   }).value_or(std::nullopt);
  if (front.machines) add_speeds(*front.machines, front);
}

/// Reads the largest comparison, and what follows from it.
void read_comparison(const std::vector<FoundReport>& reports, Front& front) {
  const FoundReport* largest = largest_comparison(reports);
  front.comparison = read_or_mark(largest, front, comparison_of);
  if (!front.comparison) return;
  add_places(*front.comparison, front);
  front.chooser = read_or_mark(largest, front, [&](const FoundReport& report) {
    return chooser_of(report, family_titles(reports));
  });
  const auto data = largest->data.get<ComparisonData>();
  front.runs = data.runs;
  front.solvers = static_cast<std::int64_t>(data.solvers.size());
  for (const FamilySize& family : front.comparison->families) {
    if (family.name != "all") front.problems += static_cast<std::int64_t>(family.problems);
  }
  const auto simulating = std::ranges::find_if(
      reports, [](const FoundReport& r) { return holds(r.headline, "simulations"); });
  if (simulating == reports.end()) return;
  front.pairs = read_or_mark(&*simulating, front, [&](const FoundReport& report) {
                  return pairs_of(report, *largest);
                }).value_or(std::nullopt);
}

void add_answers(const std::vector<FoundReport>& reports, Front& front) {
  const FoundReport* comparison = front.comparison ? largest_comparison(reports) : nullptr;
  const Answered answered{front.machines, front.chooser, front.pairs, comparison, reports};
  front.answers = first_answers(answered);
  std::vector<FrontExcerpt> further = further_answers(answered);
  front.question.insert(front.question.begin(), std::make_move_iterator(further.begin()),
                        std::make_move_iterator(further.end()));
}

}  // namespace

Front front_of(const std::vector<FoundReport>& reports) {
  Front front;
  for (const FoundReport& report : reports) {
    front.cards.push_back(card_of(report));
    if (!report.headline) continue;
    add_excerpts(*report.headline, report.folder, front);
    for (const FoundPage& page : report.pages) {
      if (page.headline) add_excerpts(*page.headline, report.folder + "/" + page.folder, front);
    }
    if (!front.motion && holds(report.headline, "simulations") &&
        !report.headline->charts.empty()) {
      front.motion = FrontCharts{report.folder, report.headline->charts};
    }
  }
  read_machines(reports, front);
  read_comparison(reports, front);
  add_answers(reports, front);
  for (const report::ReportKind& kind : report::report_kinds()) {
    const bool there = std::ranges::any_of(
        reports, [&](const FoundReport& report) { return report.kind.name == kind.name; });
    if (!there) front.missing.push_back(kind);
  }
  return front;
}

namespace {

using report::Chart;
using report::Mark;
using report::Sample;
using report::Scale;
using report::Series;

constexpr int width = 520, height = 360;

/// Returns true if another sample dominates this one.
bool is_beaten(const Sample& sample, const std::vector<Sample>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Sample& other) {
    return other.position <= sample.position && *other.value >= *sample.value &&
           (other.position < sample.position || *other.value > *sample.value);
  });
}

/// The kind of a solver; nothing if the data have none.
std::string kind_in(const Comparison& comparison, const std::string& solver) {
  const auto kind = comparison.kinds.find(solver);
  return kind == comparison.kinds.end() ? "" : kind->second;
}

/// The entries of one family with its largest budget, by kind. Those on the Pareto front have
/// names, and those that always have.
Chart entries_chart(const Comparison& comparison, std::size_t family) {
  double budget = 0;
  for (const Entry& entry : comparison.entries) {
    if (entry.family == family) budget = std::max(budget, entry.budget);
  }
  Chart chart{.name = "front-speed-accuracy",
              .title = "",
              .x = {"evaluations for each variable", Scale::logarithmic},
              .y = {"success rate [%]", Scale::linear, report::Range{0, 100}},
              .width = width,
              .height = height};
  std::vector<const Entry*> shown;
  std::vector<Sample> places;
  for (const Entry& entry : comparison.entries) {
    const bool fits = entry.family == family && entry.budget == budget && entry.complete;
    if (!fits || entry.evaluations.value_or(0) <= 0 || !entry.solved) continue;
    shown.push_back(&entry);
    places.push_back({*entry.evaluations, 100 * *entry.solved});
  }
  std::map<std::string, Series> kinds;
  const Entry* best = nullptr;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Entry& entry = *shown[i];
    const std::string kind = kind_in(comparison, entry.solver);
    Series& series = kinds.try_emplace(kind, Series{kind, Mark::points, {}}).first->second;
    const bool named = !is_beaten(places[i], places) ||
                       std::ranges::find(always_named, entry.solver) != std::end(always_named);
    series.samples.push_back(places[i]);
    if (named) series.samples.back().name = entry.solver;
    if (best == nullptr || *entry.solved > *best->solved) best = &entry;
  }
  for (auto& [kind, series] : kinds) chart.series.push_back(std::move(series));
  if (best != nullptr) {
    chart.title = fmt::format("{}: {} solves most, {:.0f} % in {:.3g} evaluations a variable",
                              comparison.families[family].name, best->solver, 100 * *best->solved,
                              *best->evaluations);
  }
  return chart;
}

}  // namespace

std::vector<Chart> front_charts(const Front& front) {
  std::vector<Chart> charts;
  if (front.comparison && !front.comparison->families.empty()) {
    charts.push_back(entries_chart(*front.comparison, 0));
  }
  if (front.motion) {
    Chart& chart = charts.emplace_back(front.motion->charts.front());
    chart.name = "front-" + chart.name;
    chart.width = width;
    chart.height = height;
  }
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  return charts;
}

Chart pairs_chart(const Pairs& pairs) {
  const std::vector<Pair> all = all_pairs(pairs), front = leading(within_range(pairs));
  Chart chart{
      .name = "front-solver-and-simulation",
      .title = title_of(pairs),
      .x = {"processor time to the threshold, with the fastest solver [s]", Scale::logarithmic},
      .y = {"error of the threshold, at most [rad/s]", Scale::logarithmic},
      .width = 780,
      .height = 420,
      .description = finding_of(pairs)};
  Series line{.label = "none is as fast and as accurate", .mark = Mark::steps, .samples = {}};
  for (const Pair& pair : front) line.samples.push_back({pair.seconds, pair.error});
  if (front.size() > 1) chart.series.push_back(std::move(line));
  for (std::size_t m = 0; m < pairs.simulations.size(); ++m) {
    const std::string& name = pairs.simulations[m].simulation;
    if (m == 0 || pairs.simulations[m - 1].simulation != name) {
      chart.series.push_back({.label = name, .mark = Mark::points, .samples = {}});
    }
    const Pair* fastest = nullptr;
    for (const Pair& pair : all) {
      if (pair.simulation != m) continue;
      if (fastest == nullptr || pair.seconds < fastest->seconds) fastest = &pair;
    }
    const bool leads =
        std::ranges::any_of(front, [&](const Pair& pair) { return pair.simulation == m; });
    Sample dot{fastest->seconds, fastest->error};
    if (leads) dot.name = name_of(pairs, *fastest);
    chart.series.back().samples.push_back(std::move(dot));
  }
  return chart;
}

}  // namespace ricochet::site
