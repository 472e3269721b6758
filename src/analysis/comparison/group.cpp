#include "src/analysis/comparison/group.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/attainment.h"
#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

/// A report lists every result of a group with at most this many.
constexpr std::size_t shown_rows = 80;

Json interval_of(const Interval& interval) {
  const auto end = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"lower", end(interval.lower)}, {"upper", end(interval.upper)}};
}

Json share_data(const SolvedShare& solved) {
  Json data = interval_of(solved.interval);
  data["share"] = solved.share;
  return data;
}

Json estimate_data(const Estimate& estimate) {
  Json data = interval_of(estimate.interval);
  data["value"] = std::isfinite(estimate.value) ? Json(estimate.value) : Json();
  return data;
}

Json result_data(const CellResult& of_cell) {
  const Cell& cell = of_cell.cell->cell;
  const Result result = result_of(of_cell.outcomes);
  Json terminations = Json::array();
  for (const auto& [reason, times] : result.terminations) {
    terminations.push_back({{"reason", reason}, {"times", times}});
  }
  return {{"problem", cell.problem},
          {"solver", cell.solver},
          {"formulation", cell.formulation},
          {"surrogate", of_cell.cell->formulation.smoothing > 0},
          {"budget", cell.budget},
          {"runs", result.runs},
          {"distinct", result.distinct},
          {"found", share_data(result.found)},
          {"returned", share_data(result.returned)},
          {"running_time",
           result.returned_running_time ? estimate_data(*result.returned_running_time) : Json()},
          {"milliseconds", result.seconds_to_solve ? Json(1e3 * *result.seconds_to_solve) : Json()},
          {"gap", estimate_data(result.gap)},
          {"failed", result.failed},
          {"terminations", std::move(terminations)}};
}

/// The share of targets reached over the evaluations, with the ends alone of level parts.
Json curve_data(const Rating& rating) {
  Json progress = Json::array();
  for (const Reach& reach : rating.progress) {
    const std::size_t many = progress.size();
    const bool level = many > 1 && progress[many - 1]["share"] == reach.share &&
                       progress[many - 2]["share"] == reach.share;
    if (level) progress.erase(many - 1);
    progress.push_back({{"evaluations", reach.evaluations}, {"share", reach.share}});
  }
  return {{"solver", rating.solver},
          {"formulation", rating.formulation},
          {"progress", std::move(progress)}};
}

/// Curves of the ECDF: of the first entries, of the paper's algorithm if it is none of them, and of
/// other solvers, each in its best formulation, to compare with.
struct Curves {
  Json first = Json::array(), paper = Json::array(), rest = Json::array();
};

Curves curves_of(const std::vector<Rating>& ratings) {
  constexpr std::size_t told = 5, shown = 6;  // more lines than this cannot be told apart, or seen
  Curves curves;
  std::set<std::string> drawn;
  for (const Rating& rating : ratings) {
    if (curves.first.size() < told) {
      curves.first.push_back(curve_data(rating));
    } else if (drawn.contains(rating.solver)) {
      continue;
    } else if (rating.solver == paper_solver) {
      curves.paper.push_back(curve_data(rating));
    } else if (curves.rest.size() < shown) {
      curves.rest.push_back(curve_data(rating));
    }
    drawn.insert(rating.solver);
  }
  return curves;
}

Json rating_data(const Rating& rating) {
  const Reach& last = rating.progress.back();
  return {{"solver", rating.solver},
          {"formulation", rating.formulation},
          {"surrogate", rating.surrogate},
          {"problems", rating.problems},
          {"never", rating.never},
          {"found", rating.found},
          {"returned", rating.returned},
          {"share", last.share},
          {"lower", last.interval.lower},
          {"upper", last.interval.upper},
          {"best", rating.probability_of_being_best},
          {"rank", rating.rank}};
}

/// The first by the returned points, and by the best evaluated ones if that is another one; members
/// are null if none is first.
Json leader_data(const std::vector<Rating>& by_returned, const std::vector<Rating>& by_evaluated,
                 std::size_t problems) {
  const Rating* first = leader_of(by_returned);
  const Rating* other = leader_of(by_evaluated, Criterion::evaluated);
  Json data = rating_data(first != nullptr ? *first : by_returned.front());
  if (first == nullptr) {
    for (auto& [key, value] : data.items()) value = nullptr;
  }
  const auto name = [](const Rating* r) { return r ? entry(r->solver, r->formulation) : ""; };
  const bool differs = name(first) != name(other);
  data["differs"] = differs;
  data["by_evaluated"] = nullptr;
  if (differs && other != nullptr) {
    data["by_evaluated"] = {{"entry", name(other)},
                            {"found", other->found},
                            {"returned", other->returned},
                            {"surrogate", other->surrogate}};
  }
  data["of"] = problems;
  data["single"] = problems == 1;
  data["ranked"] = std::count_if(by_returned.begin(), by_returned.end(),
                                 [](const Rating& r) { return r.rank.has_value(); });
  data["entries"] = by_returned.size();
  return data;
}

/// Entries that are compared problem by problem.
constexpr std::size_t compared = 20;

/// Returns a row for each of the first entries with the success rate on every problem with
/// the largest budget; null if it does not take the problem in this formulation.
Json share_rows(const Comparison& comparison, const Group& group, const Json& ratings) {
  std::map<std::string, Json> rows;
  for (const CellResult& result : comparison.results) {
    const Cell& cell = result.cell->cell;
    const auto place =
        std::find(group.problems.begin(), group.problems.end(), result.cell->problem);
    const bool largest = cell.budget == comparison.part->budgets.back();
    if (place == group.problems.end() || !largest) continue;
    Json& cells = rows[entry(cell.solver, cell.formulation)];
    if (cells.is_null()) cells = Json(group.problems.size(), Json());
    cells[static_cast<std::size_t>(place - group.problems.begin())] =
        result_of(result.outcomes).returned.share;
  }
  Json all = Json::array();
  for (std::size_t i = 0; i < std::min(compared, ratings.size()); ++i) {
    const std::string name = entry(ratings[i]["solver"], ratings[i]["formulation"]);
    all.push_back({{"entry", name}, {"shares", std::move(rows.at(name))}});
  }
  return all;
}

std::shared_ptr<const Targets> targets_on(const Comparison& comparison, std::size_t problem) {
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem == problem) return result.targets;
  }
  return nullptr;  // a group has problems with results only
}

}  // namespace

bool Group::has(const CellResult& result) const {
  return std::find(problems.begin(), problems.end(), result.cell->problem) != problems.end();
}

std::vector<Group> groups_of(const Comparison& comparison) {
  std::vector<Group> groups;
  for (const std::size_t q : comparison.problems()) {
    const std::string& family = comparison.campaign->family_of(q);
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group& group) { return group.family == family; });
    if (known == groups.end()) {
      groups.push_back({family, {q}});
    } else {
      known->problems.push_back(q);
    }
  }
  return groups;
}

Ratings ratings_of(const Comparison& comparison, const std::vector<Group>& groups) {
  Ratings ratings;
  for (const Group& group : groups) {
    auto& of_group = ratings.emplace_back();
    for (std::size_t b = 0; b < comparison.part->budgets.size(); ++b) {
      of_group.push_back({rate(comparison, group.problems, b),
                          rate(comparison, group.problems, b, Criterion::evaluated)});
    }
  }
  return ratings;
}

Json group_data(const Comparison& comparison, const std::vector<Group>& groups,
                const Ratings& rated) {
  const std::vector<std::int64_t>& all_budgets = comparison.part->budgets;
  Json all = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    Json budgets = Json::array();
    for (std::size_t b = 0; b < all_budgets.size(); ++b) {
      const auto& [by_returned, by_evaluated] = rated[g][b];
      Curves curves = curves_of(by_returned);
      budgets.push_back({{"budget", all_budgets[b]},
                         {"of", group.problems.size()},
                         {"leader", leader_data(by_returned, by_evaluated, group.problems.size())},
                         {"ratings", report::list_of(by_returned, rating_data)},
                         {"first", std::move(curves.first)},
                         {"paper", std::move(curves.paper)},
                         {"rest", std::move(curves.rest)}});
    }
    Json problems = Json::array();
    for (const std::size_t q : group.problems) {
      const Problem& stated = comparison.campaign->problems()[q];
      const Targets& targets = *targets_on(comparison, q);
      problems.push_back({{"problem", stated.name},
                          {"variables", stated.dimension()},
                          {"constraints", stated.constraints},
                          {"targets", targets.size()},
                          {"easiest", targets.back()},
                          {"best_known", stated.best_known}});
    }
    std::vector<const CellResult*> mine;
    for (const std::size_t q : group.problems) {
      for (const CellResult& result : comparison.results) {
        if (result.cell->problem == q) mine.push_back(&result);
      }
    }
    const bool few = mine.size() <= shown_rows;
    Json rows = Json::array();
    if (few) {
      for (const CellResult* result : mine) rows.push_back(result_data(*result));
    }
    const Json last = budgets.back();
    all.push_back({{"family", group.family},
                   {"ratings", last["ratings"]},  // with the largest budget
                   {"drawn", last["first"]},
                   {"paper", last["paper"]},
                   {"rest", last["rest"]},
                   {"budgets", std::move(budgets)},
                   {"problems", std::move(problems)},
                   {"shares", share_rows(comparison, group, last["ratings"])},
                   {"few", few},
                   {"results", std::move(rows)}});
  }
  return all;
}

}  // namespace ricochet::studies::comparison
