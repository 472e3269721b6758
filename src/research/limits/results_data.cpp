#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "src/studies/limits/results.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;
using report::Json;
using report::list_of;

Json json_of(const Judged& point) {
  return {{"reading", name_of(point.fit.reading)},
          {"constants", point.fit.freed.size()},
          {"threshold_error", point.fine.threshold_error},
          {"worst_threshold", point.fine.worst_threshold},
          {"within", point.fine.within},
          {"exact_counts", point.fine.exact_counts},
          {"purity", point.fine.purity},
          {"misclassified", point.fine.misclassified},
          {"loudness", point.fine.loudness},
          {"right_examples", point.fine.right_examples},
          {"quiet_share", point.fine.quiet_share},
          {"claims", point.claims},
          {"coarse_error", point.coarse.threshold_error}};
}

/// Judged points with one number of fitted constants, of one reading.
struct Group {
  Reading reading;
  std::size_t constants;
  std::vector<const Judged*> points;
};

std::vector<Group> groups_of(const std::vector<Judged>& points) {
  std::vector<Group> groups;
  for (const Judged& point : points) {
    const auto same = [&](const Group& g) {
      return g.reading == point.fit.reading && g.constants == point.fit.freed.size();
    };
    auto group = std::ranges::find_if(groups, same);
    if (group == groups.end()) {
      groups.push_back({point.fit.reading, point.fit.freed.size(), {}});
      group = groups.end() - 1;
    }
    group->points.push_back(&point);
  }
  return groups;
}

/// The lowest by a few numbers, one after the other.
template <class Order>
const Judged* first_by(const Group& group, Order order) {
  const Judged* best = nullptr;
  for (const Judged* point : group.points) {
    if (best == nullptr || order(*point) < order(*best)) best = point;
  }
  return best;
}

Json corner(const std::string& what, const Judged* point) {
  Json row = json_of(*point);
  row["corner"] = what;
  return row;
}

void add_corners(Json& rows, const Group& group) {
  if (group.points.empty()) return;
  using Key = std::array<double, 3>;
  rows.push_back(corner("least error", first_by(group, [](const Judged& p) {
                          return Key{double(p.examples_missed()), p.fine.threshold_error, 0};
                        })));
  rows.push_back(corner(
      "most counts", first_by(group, [](const Judged& p) {
        return Key{double(p.examples_missed()), double(p.counts_missed()), p.fine.threshold_error};
      })));
  rows.push_back(
      corner("purest", first_by(group, [](const Judged& p) {
               return Key{double(p.examples_missed()), -p.fine.purity, p.fine.threshold_error};
             })));
  rows.push_back(corner("compromise", first_by(group, [](const Judged& p) {
                          return Key{p.claims, 0, 0};
                        })));
}

/// The best pairs of two numbers, of points with all examples right.
template <class First, class Second>
Json pairs_of(const Group& group, First first, Second second) {
  std::vector<Pair> pairs;
  for (const Judged* p : group.points) {
    if (p->examples_missed() == 0) pairs.emplace_back(first(*p), second(*p));
  }
  return list_of(best_pairs(pairs), [](const Pair& pair) -> Json {
    return {{"x", pair.first}, {"y", pair.second}};
  });
}

Json curves_of(const Group& group) {
  const auto error = [](const Judged& p) { return p.fine.threshold_error; };
  const auto counts = [](const Judged& p) { return double(p.counts_missed()); };
  const auto impurity = [](const Judged& p) { return 1 - p.fine.purity; };
  return {{"constants", group.constants},
          {"reading", name_of(group.reading)},
          {"error_by_counts", pairs_of(group, counts, error)},
          {"error_by_impurity", pairs_of(group, impurity, error)},
          {"impurity_by_counts", pairs_of(group, counts, impurity)}};
}

/// How alike the fronts of several seeds are.
Json seeds_of(const Results& results) {
  std::map<std::size_t, std::vector<double>> shares;
  for (const ChainedFront& front : results.fronts) {
    if (front.freedom.reading != results.plan.main) continue;
    shares[front.freedom.freed.size()].push_back(front.dominated_share());
  }
  Json rows = Json::array();
  for (const auto& [constants, of_seeds] : shares) {
    const auto [lowest, highest] = std::minmax_element(of_seeds.begin(), of_seeds.end());
    rows.push_back({{"constants", constants},
                    {"shares", of_seeds},
                    {"apart", *highest > 0 ? (*highest - *lowest) / *highest : 0}});
  }
  return rows;
}

Json json_of(const LongSearches& one, const Plan& plan) {
  const bool error = one.target == "threshold-error";
  double half = one.found.front().half.misfit;
  for (const GoalFound& found : one.found) half = std::min(half, found.half.misfit);
  Json ends = Json::array();
  for (std::size_t i = 0; i < plan.solvers.size() * plan.seeds.size(); ++i) {
    ends.push_back(
        {{"end", i < one.found.size() ? Json(one.found[i].whole.misfit) : Json(nullptr)}});
  }
  Json row = json_of(one.best);
  row.update(
      {{"target", error ? "rms error" : "worst error"},
       {"ends", ends},
       {"lowest", one.lowest()},
       {"from_fronts", list_of(one.from_fronts, [](const GoalFound& f) { return f.whole.misfit; })},
       {"apart", one.apart()},
       {"fronts_apart", one.fronts_apart()},
       {"half", half},
       {"judged", error ? one.best.fine.threshold_error : one.best.fine.worst_threshold}});
  return row;
}

Json json_of(const Asked& asked) {
  Json row = json_of(asked.best);
  row["asked"] = asked.group.name;
  row["ends"] = list_of(asked.found, [](const GoalFound& f) { return f.whole.misfit; });
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
            {"gains", list_of(e.gains, [](const Exclusion::Gain& g) -> Json {
               return {{"name", g.name}, {"gain", g.gain}};
             })}};
  });
  const auto beyond =
      std::ranges::count_if(all.all, [&](const Exclusion& e) { return e.relief() > all.spread(); });
  return {{"start", all.start},     {"controls", all.controls}, {"control", all.controls.front()},
          {"spread", all.spread()}, {"beyond", beyond},         {"rows", rows},
          {"dearest", rows.front()}};
}

/// The reliefs of each case by what is dropped.
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
  return {{"cases", list_of(results.cases, [](const Case& c) { return c.id; })}, {"rows", rows}};
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

/// By how much each threshold must err at least, the least squares of all ten together.
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

Json json_of(const GridScan& grid) {
  const auto name = [](Open open) {
    std::string text(open_constants()[static_cast<std::size_t>(open)].name);
    std::ranges::replace(text, '_', ' ');
    return text;
  };
  const auto value = [&](std::size_t axis, int step) {
    const Freedom freedom{grid.about.reading, {grid.axes[axis]}, grid.about.constants};
    const Vector u = Vector::Constant(1, double(step) / (grid.steps - 1));
    return constants_at(freedom, u)[static_cast<std::size_t>(grid.axes[axis])];
  };
  Json columns = Json::array();
  Json rows = Json::array();
  for (int k = 0; k < grid.steps; ++k) {
    columns.push_back({{"value", value(1, k)}});
    rows.push_back({{"value", value(0, k)}, {"errors", Json::array()}});
    for (const double error : grid.map[static_cast<std::size_t>(k)]) {
      rows.back()["errors"].push_back(100 * std::min(error, 1.0));
    }
  }
  double points = 1;
  for (std::size_t i = 0; i < grid.axes.size(); ++i) points *= grid.steps;
  return {{"axes", list_of(grid.axes, name)},
          {"down", name(grid.axes[0])},
          {"across", name(grid.axes[1])},
          {"steps", grid.steps},
          {"points", static_cast<std::int64_t>(points)},
          {"constants", grid.about.freed.size()},
          {"threshold_error", grid.threshold_error},
          {"worst_threshold", grid.worst_threshold},
          {"own_error", grid.own_error},
          {"own_worst", grid.own_worst},
          {"better", grid.threshold_error < grid.own_error},
          {"columns", columns},
          {"rows", rows}};
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
  Json order = Json::array();
  for (std::size_t k = 0; k < plan.order.size(); ++k) {
    std::string name(open_constants()[static_cast<std::size_t>(plan.order[k])].name);
    std::ranges::replace(name, '_', ' ');
    order.push_back(name);
  }
  Json searches = Json::array();
  for (const Solver& solver : plan.solvers) {
    for (const int seed : plan.seeds) searches.push_back({{"solver", solver.name}, {"seed", seed}});
  }
  return {{"main", name_of(plan.main)},
          {"order", order},
          {"fewest", plan.first_constants},
          {"most", plan.order.size()},
          {"seeds", plan.seeds},
          {"seed_count", plan.seeds.size()},
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

/// The best of everything that was judged, by one number.
template <class Number>
Json best_judged(const Results& results, Number number) {
  const Judged* best = &results.long_searches.front().best;
  const auto look = [&](const Judged& point) {
    if (number(point) < number(*best)) best = &point;
  };
  for (const LongSearches& one : results.long_searches) look(one.best);
  for (const Asked& one : results.asked) look(one.best);
  for (const Judged& point : results.points) look(point);
  return json_of(*best);
}

Json json_of(const SymmetryCheck& check, const char* what, const char* changes) {
  return {
      {"symmetry", what}, {"changes", changes}, {"counts", check.counts}, {"alike", check.alike}};
}

}  // namespace

Json data_of(const Results& results) {
  Json corners = Json::array();
  Json other_corners = Json::array();
  Json fronts = Json::array();
  Json other_fronts = Json::array();
  for (const Group& group : groups_of(results.points)) {
    const bool main = group.reading == results.plan.main;
    add_corners(main ? corners : other_corners, group);
    (main ? fronts : other_fronts).push_back(curves_of(group));
  }
  const Plan& plan = results.plan;
  return {
      {"plan", json_of(plan, results)},
      {"ordered",
       {{"rms", results.ordered.root_mean_square},
        {"largest", results.ordered.largest},
        {"rows", ordered_rows(results)}}},
      {"proportional",
       {{"rms", results.proportional.root_mean_square}, {"largest", results.proportional.largest}}},
      {"indifferent",
       {{"rms", results.indifferent.root_mean_square}, {"largest", results.indifferent.largest}}},
      {"responses", list_of(results.responses, [](const Response& r) { return json_of(r); })},
      {"first_response", json_of(results.responses.front())},
      {"symmetries",
       {{"factor", results.symmetries.factor},
        {"rows",
         {json_of(results.symmetries.space, "of size",
                  "forces, clearance, start velocity and slowest impact, all times the factor"),
          json_of(results.symmetries.time, "of time",
                  "forces by the factor squared, velocities and the plate's speed by it")}}}},
      {"best_error", best_judged(results, [](const Judged& p) { return p.fine.threshold_error; })},
      {"best_worst", best_judged(results, [](const Judged& p) { return p.fine.worst_threshold; })},
      {"corners", corners},
      {"other_corners", other_corners},
      {"fronts", fronts},
      {"other_fronts", other_fronts},
      {"front_seeds", seeds_of(results)},
      {"doubt",
       {{"points", results.doubt.points},
        {"median_error", results.doubt.median_error},
        {"largest_error", results.doubt.largest_error},
        {"largest_purity", results.doubt.largest_purity},
        {"other_counts", results.doubt.other_counts},
        {"other_examples", results.doubt.other_examples}}},
      {"long_searches",
       list_of(results.long_searches, [&](const LongSearches& l) { return json_of(l, plan); })},
      {"main_error", json_of(results.long_searches[0], plan)},
      {"main_worst", json_of(results.long_searches[1], plan)},
      {"asked", list_of(results.asked, [](const Asked& a) { return json_of(a); })},
      {"exclusion", json_of(results.exclusion)},
      {"relief_map", relief_map(results)},
      {"grid", json_of(results.grid)},
      {"curves", list_of(results.curves, [](const ResponseCurve& c) { return json_of(c); })},
      {"paper_curve", list_of(results.responses.front().cases, [](const Case& c) -> Json {
         return {{"x", c.disturbance}, {"y", *c.claim.threshold}};
       })}};
}

}  // namespace ricochet::studies::limits
