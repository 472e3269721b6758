#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/research/limits/front_data.h"
#include "src/research/limits/results.h"

namespace ricochet::studies::limits {

RICOCHET_WRITTEN_AS_JSON(OrderBound, root_mean_square, largest);
RICOCHET_WRITTEN_AS_JSON(SymmetryCheck, counts, alike);
RICOCHET_WRITTEN_AS_JSON(CoarseDoubt, points, median_error, largest_error, largest_purity,
                         other_counts, other_examples);
RICOCHET_WRITTEN_AS_JSON(Exclusion::Gain, name, gain);
RICOCHET_WRITTEN_AS_JSON(GridScan, steps, threshold_error, worst_threshold, own_error, own_worst);

namespace {

using namespace carrier_track;
using calibration::words_of;
using report::Json;
using report::list_of;

double end_of(const GoalFound& found) {
  return found.whole.loss;
}

Json json_of(const LongSearches& one, const Plan& plan) {
  const bool error = one.target == "threshold-error";
  double half = one.found.front().half.loss;
  for (const GoalFound& found : one.found) half = std::min(half, found.half.loss);
  Json ends = Json::array();
  for (std::size_t i = 0; i < plan.solvers.size() * plan.seeds.size(); ++i) {
    ends.push_back({{"end", i < one.found.size() ? Json(one.found[i].whole.loss) : Json(nullptr)}});
  }
  Json row = one.best;
  row.update({{"target", error ? "rms error" : "worst error"},
              {"ends", ends},
              {"lowest", one.lowest()},
              {"from_fronts", list_of(one.from_fronts, end_of)},
              {"apart", one.apart()},
              {"fronts_apart", one.fronts_apart()},
              {"half", half},
              {"judged", error ? one.best.fine.threshold_error : one.best.fine.worst_threshold}});
  return row;
}

Json json_of(const Asked& asked) {
  Json row = asked.best;
  row["asked"] = asked.group.name;
  row["ends"] = list_of(asked.found, end_of);
  return row;
}

Json json_of(const Exclusions& all) {
  Json rows = list_of(all.all, [&](const Exclusion& e) -> Json {
    return {{"dropped", e.dropped.name},
            {"its_share", e.its_share},
            {"rest", e.rest},
            {"rest_without", e.rest_without},
            {"relief", e.relief()},
            {"beyond_chance", e.relief() > all.spread()},
            {"gains", e.gains}};
  });
  const auto beyond =
      std::ranges::count_if(all.all, [&](const Exclusion& e) { return e.relief() > all.spread(); });
  return {{"start", all.start},     {"controls", all.controls}, {"control", all.controls.front()},
          {"spread", all.spread()}, {"beyond", beyond},         {"rows", rows},
          {"dearest", rows.front()}};
}

/// The reliefs of each case by dropped claim.
Json relief_map(const Results& results) {
  Json rows = Json::array();
  for (const auto& [part, name] :
       {std::pair{Part::purity, "purity"}, std::pair{Part::count, "quiet count"},
        std::pair{Part::threshold, "threshold"}}) {
    Json cells = Json::array();
    for (const Case& c : results.cases) {
      for (const Exclusion& e : results.exclusion.all) {
        if (e.dropped.claims == std::vector{Claimed{part, c.id}}) cells.push_back(e.relief());
      }
    }
    rows.push_back({{"part", name}, {"reliefs", cells}});
  }
  return {{"cases", list_of(results.cases, &Case::id)}, {"rows", rows}};
}

Json json_of(const Response& response) {
  std::string cases, thresholds;
  for (const Case& c : response.cases) {
    cases += fmt::format("{}{}", cases.empty() ? "" : ", ", c.id);
    thresholds += fmt::format("{}{}", thresholds.empty() ? "" : ", ", *c.claim.threshold);
  }
  const bool falls = response.cases.back().claim.threshold < response.cases.front().claim.threshold;
  return {{"cases", cases},
          {"thresholds", thresholds},
          {"first_share", falls ? Json(response.first_share) : Json(nullptr)},
          {"falls", falls},
          {"below_chord", response.below_chord},
          {"bound", response.below_chord / 2}};
}

/// The least error of each threshold, from the least squares of all ten together.
Json ordered_rows(const Results& results) {
  Json rows = Json::array();
  const std::vector<double> logs = log_thresholds(results.cases);
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    rows.push_back({{"id", results.cases[i].id},
                    {"paper", *results.cases[i].claim.threshold},
                    {"nearest", std::exp(results.ordered.nearest[i])},
                    {"off", std::exp(results.ordered.nearest[i] - logs[i]) - 1}});
  }
  return rows;
}

/// The values of a parameter at the steps of its axis.
double value_on(const GridScan& grid, std::size_t axis, int step) {
  const Parameterisation parameterisation{
      grid.about.interpretation, {grid.axes[axis]}, grid.about.constants};
  const Vector u = Vector::Constant(1, double(step) / (grid.steps - 1));
  return constants_at(parameterisation, u)[static_cast<std::size_t>(grid.axes[axis])];
}

Json grid_data(const GridScan& grid) {
  Json columns = Json::array();
  Json rows = Json::array();
  for (int k = 0; k < grid.steps; ++k) {
    columns.push_back({{"value", value_on(grid, 1, k)}});
    rows.push_back({{"value", value_on(grid, 0, k)},
                    {"errors", list_of(grid.map[static_cast<std::size_t>(k)],
                                       [](double error) { return 100 * std::min(error, 1.0); })}});
  }
  Json data = grid;
  data.update({{"axes", list_of(grid.axes, words_of)},
               {"down", words_of(grid.axes[0])},
               {"across", words_of(grid.axes[1])},
               {"points", std::llround(std::pow(grid.steps, grid.axes.size()))},
               {"constants", grid.about.free.size()},
               {"better", grid.threshold_error < grid.own_error},
               {"columns", columns},
               {"rows", rows}});
  return data;
}

Json json_of(const ResponseCurve& curve) {
  Json samples = Json::array();
  for (std::size_t i = 0; i < curve.disturbances.size(); ++i) {
    samples.push_back({{"x", curve.disturbances[i]}, {"y", curve.thresholds[i]}});
  }
  return {{"fit", curve.fit}, {"samples", samples}};
}

std::int64_t evaluations_of(const Plan& plan, const Results& results) {
  std::int64_t sum = 0;
  for (const LongSearches& one : results.long_searches) {
    sum += static_cast<std::int64_t>(one.searches.size()) * plan.long_evaluations;
  }
  for (const Asked& one : results.asked) {
    sum += static_cast<std::int64_t>(one.found.size()) * plan.asked_evaluations;
  }
  for (const LongSearches& one : results.long_searches) {
    sum += static_cast<std::int64_t>(one.from_fronts.size()) * plan.near_evaluations;
  }
  sum +=
      static_cast<std::int64_t>(results.fronts.size()) * plan.population * (plan.generations + 1);
  sum += static_cast<std::int64_t>(
             2 * (results.exclusion.all.size() + results.exclusion.controls.size())) *
         plan.exclusion.evaluations;
  return sum;
}

Json json_of(const Plan& plan, const Results& results) {
  Json searches = Json::array();
  for (const Solver& solver : plan.solvers) {
    for (const int seed : plan.seeds) searches.push_back({{"solver", solver.name}, {"seed", seed}});
  }
  return {{"main", name_of(plan.main)},
          {"order", list_of(plan.order, words_of)},
          {"fewest", plan.first_constants},
          {"most", plan.order.size()},
          {"seeds", plan.seeds},
          {"searches", searches},
          {"front_evaluations", plan.population * (plan.generations + 1)},
          {"population", plan.population},
          {"long_evaluations", plan.long_evaluations},
          {"near", plan.near.name},
          {"near_evaluations", plan.near_evaluations},
          {"asked_evaluations", plan.asked_evaluations},
          {"exclusion_solver", plan.exclusion.solver.name},
          {"exclusion_evaluations", plan.exclusion.evaluations},
          {"step", plan.step},
          {"finer", finer},
          {"evaluations", evaluations_of(plan, results)}};
}

/// The best of all evaluated points by one number.
template <class Number>
Json best_judged(const Results& results, Number number) {
  const Judged* best = &results.long_searches.front().best;
  const auto look = [&](const Judged& point) {
    if (number(point) < number(*best)) best = &point;
  };
  for (const LongSearches& one : results.long_searches) look(one.best);
  for (const Asked& one : results.asked) look(one.best);
  for (const Judged& point : results.points) look(point);
  return *best;
}

Json symmetry_data(const SymmetryCheck& check, const char* what, const char* changes) {
  Json row = {{"symmetry", what}, {"changes", changes}};
  row.update(Json(check));
  return row;
}

}  // namespace

Json data_of(const Results& results) {
  const Plan& plan = results.plan;
  Json data = {
      {"plan", json_of(plan, results)},
      {"ordered", results.ordered},
      {"proportional", results.proportional},
      {"indifferent", results.indifferent},
      {"responses", list_of(results.responses, [](const Response& r) { return json_of(r); })},
      {"first_response", json_of(results.responses.front())},
      {"symmetries",
       {{"factor", results.symmetries.factor},
        {"rows",
         {symmetry_data(
              results.symmetries.space, "of size",
              "forces, clearance, start velocity and slowest impact, all times the factor"),
          symmetry_data(results.symmetries.time, "of time",
                        "forces by the factor squared, velocities and the plate's speed by it")}}}},
      {"best_error", best_judged(results, [](const Judged& p) { return p.fine.threshold_error; })},
      {"best_worst", best_judged(results, [](const Judged& p) { return p.fine.worst_threshold; })},
      {"doubt", results.doubt},
      {"long_searches",
       list_of(results.long_searches, [&](const LongSearches& l) { return json_of(l, plan); })},
      {"main_error", json_of(results.long_searches[0], plan)},
      {"main_worst", json_of(results.long_searches[1], plan)},
      {"asked", list_of(results.asked, [](const Asked& a) { return json_of(a); })},
      {"exclusion", json_of(results.exclusion)},
      {"relief_map", relief_map(results)},
      {"grid", grid_data(results.grid)},
      {"curves", list_of(results.curves, [](const ResponseCurve& c) { return json_of(c); })},
      {"paper_curve", list_of(results.responses.front().cases, [](const Case& c) -> Json {
         return {{"x", c.disturbance}, {"y", *c.claim.threshold}};
       })}};
  data["ordered"]["rows"] = ordered_rows(results);
  data.update(front_data(results));
  return data;
}

}  // namespace ricochet::studies::limits
