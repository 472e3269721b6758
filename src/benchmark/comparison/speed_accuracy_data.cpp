#include "src/benchmark/comparison/speed_accuracy_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "src/benchmark/analysis/result.h"
#include "src/benchmark/comparison/solver_facts.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/mean_share.h"
#include "src/benchmark/statistics/order_statistic_interval.h"
#include "src/benchmark/statistics/pareto_front.h"
#include "src/benchmark/statistics/wilson_interval.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// Mean share with its interval: over the problems, or over the runs that differ if there is one
/// problem.
MeanShare share_of(const Entry& entry, const std::vector<double>& shares) {
  if (shares.size() > 1) return mean_share(shares);
  const double distinct = result_of(entry.results.front()->outcomes).distinct;
  return {shares.front(), wilson_interval(shares.front() * distinct, distinct)};
}

/// Adds the median optimality gap with its interval.
void add_optimality_gap(Json& row, const Entry& entry, std::vector<double> optimality_gaps) {
  if (optimality_gaps.size() == 1) {
    optimality_gaps.clear();
    for (const Outcome& outcome : entry.results.front()->outcomes) {
      optimality_gaps.push_back(
          outcome.verdict.optimality_gap.value_or(std::numeric_limits<double>::infinity()));
    }
  }
  row["optimality_gap"] = finite(quantile(optimality_gaps, 0.5));
  const auto interval = order_statistic_interval(optimality_gaps);
  row["optimality_gap_lower"] = interval ? finite(interval->lower) : Json();
  row["optimality_gap_upper"] = interval ? finite(interval->upper) : Json();
}

Json row_of(const Campaign& campaign, const EntrySet& set, const Entry& entry) {
  std::vector<double> evaluations;
  std::vector<double> seconds;
  std::vector<double> shares;
  std::vector<double> optimality_gaps;
  std::size_t runs = 0;
  for (const CellResult* result : entry.results) {
    const OnProblem one = on_problem(campaign, *result);
    evaluations.push_back(one.evaluations);
    seconds.push_back(one.seconds);
    shares.push_back(one.share);
    optimality_gaps.push_back(one.optimality_gap);
    runs += result->outcomes.size();
  }
  const MeanShare share = share_of(entry, shares);
  const bool joint = set.budget == 0;
  Json row = {{"family", set.family},
              {"part", joint ? Json() : Json(set.part + 1)},
              {"budget", joint ? Json() : Json(set.budget)},
              {"largest", set.largest},
              {"solver", entry.solver},
              {"formulation", entry.formulation},
              {"problems", entry.results.size()},
              {"complete", entry.results.size() == set.problems.size()},
              {"runs", runs},
              {"evaluations", mean_cost(evaluations)},
              {"seconds", mean_cost(seconds)},
              {"share", share.mean},
              {"share_lower", share.interval.lower},
              {"share_upper", share.interval.upper},
              {"optimality_gap", nullptr},
              {"optimality_gap_lower", nullptr},
              {"optimality_gap_upper", nullptr},
              {"on_front", false},
              {"on_time_front", false}};
  if (!joint) add_optimality_gap(row, entry, std::move(optimality_gaps));
  return row;
}

/// Marks the rows on the Pareto front.
void mark_front(Json& rows, const char* cost, const char* mark) {
  std::vector<CostAndError> points;
  for (const Json& row : rows) {
    points.push_back({row[cost].get<double>(), 1 - row["share"].get<double>()});
  }
  for (const std::size_t k : pareto_front(points)) rows[k][mark] = true;
}

/// The rows of the entries that take all problems.
Json complete_rows(const Campaign& campaign, const EntrySet& set) {
  Json rows = Json::array();
  for (const Entry& entry : set.entries) rows.push_back(row_of(campaign, set, entry));
  mark_front(rows, "evaluations", "on_front");
  mark_front(rows, "seconds", "on_time_front");
  return rows;
}

std::string spent_text(double cost, bool by_time) {
  return by_time ? fmt::format("{:.2g} ms", 1e3 * cost) : fmt::format("{:.3g} evaluations", cost);
}

/// The Pareto front in words.
std::string title_of(const std::string& name, const Json& front, std::size_t all, bool by_time) {
  const auto about = [&](const Json& dot) {
    return fmt::format("{} ({:.0f} %, {})", dot["solver"].get<std::string>(),
                       100 * dot["share"].get<double>(),
                       spent_text(dot["cost"].get<double>(), by_time));
  };
  const Json& fastest = front.front();
  const Json& surest = front.back();
  if (surest["share"].get<double>() == 0) {
    return fmt::format("{}: none of {} solvers solved a run", name, all);
  }
  if (fastest["cost"] == surest["cost"]) {
    return fmt::format("{}: {} is first in both, of {}", name, about(surest), all);
  }
  // The axis names the cost: with it the title would be too long.
  return fmt::format("{}: {} of {} lead, from {} ({:.0f} %) to {} ({:.0f} %)", name, front.size(),
                     all, fastest["solver"].get<std::string>(),
                     100 * fastest["share"].get<double>(), surest["solver"].get<std::string>(),
                     100 * surest["share"].get<double>());
}

/// Most solvers of a Pareto front that a chart names: the most accurate ones.
constexpr std::size_t most_named = 5;

/// The name beside a dot: of the best few, of the paper's algorithm and of random search.
std::string name_at(const std::string& solver, const Json& front) {
  if (solver == paper_solver) return solver + " (the paper's)";
  if (solver == "random-search") return solver;
  for (std::size_t i = front.size() - std::min(most_named, front.size()); i < front.size(); ++i) {
    if (front[i]["solver"] == solver) return solver;
  }
  return "";
}

/// The dots by the solvers' kinds, each kind with its most accurate solver first; the kinds by
/// name, so that one has the same colour in charts of the same kinds.
Json kinds_of(std::vector<Json> dots, const Json& front) {
  std::map<std::string, Json> kinds;
  std::ranges::stable_sort(dots, std::greater(),
                           [](const Json& dot) { return dot["share"].get<double>(); });
  for (Json& dot : dots) {
    const auto solver = dot["solver"].get<std::string>();
    dot["name"] = name_at(solver, front);
    kinds.try_emplace(kind_of(solver), Json::array()).first->second.push_back(std::move(dot));
  }
  return report::list_of(kinds, [](const auto& kind) {
    return Json{{"kind", kind.first}, {"dots", kind.second}};
  });
}

Json chart_of(const std::string& name, const Json& rows, bool by_time) {
  const char* const cost = by_time ? "seconds" : "evaluations";
  const char* const mark = by_time ? "on_time_front" : "on_front";
  Json front = Json::array();
  std::vector<Json> dots;
  std::size_t level = 0;
  double dearest = 0;
  for (const Json& row : rows) {
    Json dot = {{"solver", row["solver"]},
                {"cost", row[cost]},
                {"share", row["share"]},
                {"lower", row["share_lower"]},
                {"upper", row["share_upper"]}};
    dearest = std::max(dearest, row[cost].get<double>());
    if (row[mark].get<bool>()) front.push_back(dot);
    dots.push_back(std::move(dot));
  }
  std::stable_sort(front.begin(), front.end(), [](const Json& a, const Json& b) {
    return a["cost"].get<double>() < b["cost"].get<double>();
  });
  const double best = front.back()["share"].get<double>();
  for (const Json& row : rows) {
    if (!row[mark].get<bool>() && row["share_upper"].get<double>() >= best) ++level;
  }
  Json steps = front;
  steps.push_back({{"cost", dearest}, {"share", best}});
  return {{"name", fmt::format("speed-accuracy-{}{}", name, by_time ? "-seconds" : "")},
          {"family", name},
          {"about", by_time ? name + ", by time" : name},
          {"title", title_of(name, front, rows.size(), by_time)},
          {"axis", by_time ? "processor time until solved, or in all [s]"
                           : "evaluations for each variable until solved, or in all"},
          {"solvers", rows.size()},
          {"leading", front.size()},
          {"surest", front.back()["solver"]},
          {"level", level},
          {"kinds", kinds_of(std::move(dots), front)},
          {"front", std::move(front)},
          {"steps", std::move(steps)}};
}

}  // namespace

Json speed_accuracy_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  Json all = Json::array();
  Json charts = Json::array();
  Json fronts = Json::array();
  const auto add = [&](const EntrySet& set, bool draws_time) {
    Json rows = complete_rows(campaign, set);
    if (set.largest && !rows.empty()) {
      charts.push_back(chart_of(set.family, rows, false));
      if (draws_time) charts.push_back(chart_of(set.family, rows, true));
      for (const Json& row : rows) {
        const bool leads = row["on_front"].get<bool>() || row["on_time_front"].get<bool>();
        // An entry that solves nothing is not worth a row, though none may be cheaper.
        if (!leads || row["share"].get<double>() == 0) continue;
        fronts.push_back(row);
      }
    }
    for (Json& row : rows) all.push_back(std::move(row));
    for (const Entry& entry : set.partial) {
      all.push_back(row_of(campaign, set, entry));
    }
  };
  const EntrySet joint = joint_entry_set(campaign, sets);
  add(joint, true);
  for (const EntrySet& set : sets) add(set, joint.entries.empty());
  return {{"speed_accuracy", std::move(all)},
          {"speed_accuracy_charts", std::move(charts)},
          {"speed_accuracy_front", std::move(fronts)}};
}

}  // namespace ricochet::studies::comparison
