#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "src/analysis/comparison/family.h"
#include "src/analysis/comparison/leaders.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/results.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::Range;

/// A report lists every result of a group with at most this many.
constexpr std::size_t shown_results = 80;

/// Entries that are compared problem by problem.
constexpr std::size_t compared = 20;

std::shared_ptr<const Targets> targets_on(const Comparison& comparison, std::size_t problem) {
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem == problem) return result.targets;
  }
  return nullptr;  // a group has problems with results only
}

}  // namespace

Table rating_table(std::string name, const std::vector<Rating>& ratings, std::size_t problems) {
  Table table{std::move(name),
              {{"solver"},
               {"formulation"},
               {"surrogate"},
               {"takes"},
               {"problems"},
               {"rank", "mean rank", ".1f", 3},
               {"best", "P(best)", ".2f", 3},
               {"returned", "success rate [%]", ".0%", 3},
               {"share", "targets reached [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"never", "problems solved in none of its runs"},
               {"found", "success rate of the best evaluated point [%]", ".0%", 3}}};
  for (const Rating& r : ratings) {
    const Reach& last = r.progress.back();
    table.add(r.solver, r.formulation, r.surrogate, r.problems, problems, r.rank,
              r.probability_of_being_best, r.returned, last.share, last.interval.lower,
              last.interval.upper, r.never, r.found);
  }
  return table;
}

Chart solved_map(const RatedPart& part, std::size_t number) {
  const Group& group = part.groups[number];
  const std::vector<Rating>& ratings = part.most(number);
  std::map<std::string, std::vector<std::optional<double>>> rows;
  for (const CellResult& result : part.comparison.results) {
    const auto place = std::ranges::find(group.problems, result.cell->problem);
    if (place == group.problems.end() || !part.comparison.has_largest_budget(result)) continue;
    auto& cells = rows[entry(result.cell->cell.solver, result.cell->cell.formulation)];
    cells.resize(group.problems.size());
    cells[static_cast<std::size_t>(place - group.problems.begin())] =
        100 * result_of(result.outcomes).returned.share;
  }
  Chart chart{
      .name = "solved", .x = {"problem"}, .y = {""}, .heat_map = report::HeatMap{"solved [%]"}};
  report::HeatMap& map = *chart.heat_map;
  map.range = Range{0, 100};
  for (const std::size_t q : group.problems) {
    const std::string& problem = part.comparison.campaign->problems()[q].name;
    chart.x.categories.push_back(problem);
    map.column_links.push_back(fmt::format("&problem={}/{}", group.family, problem));
  }
  for (std::size_t i = std::min(compared, ratings.size()); i-- > 0;) {  // from the bottom
    const std::string name = entry(ratings[i].solver, ratings[i].formulation);
    chart.y.categories.push_back(name);
    map.rows.push_back(rows.at(name));
    map.row_links.push_back(
        fmt::format("../view#family={}&formulation=all&entry={}", group.family, name));
  }
  chart.title = fmt::format("{}, problem by problem: {} has the least mean rank", group.family,
                            chart.y.categories.back());
  chart.width = 820;
  chart.height = 120 + 16 * static_cast<int>(chart.y.categories.size());
  chart.description = "Heat map of the share solved over problem and entry.";
  return chart;
}

Table result_table(const RatedPart& part, const Group& group) {
  Table table{"results",
              {{"problem"},
               {"solver"},
               {"formulation"},
               {"budget"},
               {"returned", "", ".0%", 3},
               {"returned_lower", "", ".0%", 3},
               {"returned_upper", "", ".0%", 3},
               {"found", "", ".0%", 3},
               {"running_time", "", ".0f"},
               {"running_time_lower", "", ".0f"},
               {"running_time_upper", "", ".0f"},
               {"milliseconds", "", ".3g"},
               {"gap", "", ".3g", 3},
               {"distinct"},
               {"runs"},
               {"failed"}}};
  std::vector<const CellResult*> mine;
  for (const std::size_t q : group.problems) {
    for (const CellResult& result : part.comparison.results) {
      if (result.cell->problem == q) mine.push_back(&result);
    }
  }
  if (mine.size() > shown_results) return table;
  for (const CellResult* one : mine) {
    const Cell& cell = one->cell->cell;
    const Result r = result_of(one->outcomes);
    const auto& time = r.returned_running_time;
    table.add(cell.problem, cell.solver, cell.formulation, cell.budget, r.returned.share,
              r.returned.interval.lower, r.returned.interval.upper, r.found.share,
              value_of(time, &Estimate::value),
              value_of(time, [](const Estimate& e) { return e.interval.lower; }),
              value_of(time, [](const Estimate& e) { return e.interval.upper; }),
              value_of(r.seconds_to_solve, [](double s) { return 1e3 * s; }), r.gap, r.distinct,
              r.runs, r.failed);
  }
  return table;
}

Table problem_table(const RatedPart& part, const Group& group,
                    const std::map<std::string, std::string>& hashes) {
  Table table{"problems",
              {{"problem"},
               {"variables"},
               {"constraints"},
               {"best_known", "", ".6g", 17},
               {"provenance"},
               {"targets"},
               {"easiest", "", ".3g", 3},
               {"random", "", ".3g", 3},
               {"solving"},
               {"entries"},
               {"hash"}}};
  for (const std::size_t q : group.problems) {
    const Problem& problem = part.comparison.campaign->problems()[q];
    const Targets& targets = *targets_on(part.comparison, q);
    const Tries tries = tries_on(part.comparison, q);
    const auto hash = hashes.find(problem.name);
    table.add(problem.name, problem.dimension(), problem.constraints, problem.best_known,
              problem.provenance, targets.size(), targets.back(),
              random_search_time(part.comparison, q), tries.solving, tries.entries,
              hash == hashes.end() ? "" : hash->second);
  }
  return table;
}

}  // namespace ricochet::studies::comparison
