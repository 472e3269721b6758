#include "src/report/site/front.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

#include "src/report/site/comparison_data.h"
#include "src/report/site/front_answers.h"

namespace ricochet::site {
namespace {

constexpr const char* other_version = "Its data are another version's: the command makes it anew.";

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

}  // namespace ricochet::site
