#include "src/research/limits/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/research/limits/claims.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

constexpr double symmetry_factor = 2;  // a power of two does not change rounding
constexpr std::size_t scanned_constants = 3;
constexpr std::size_t few_constants = 5;  // of the other interpretations' first fronts
constexpr double curve_step = 0.1;        // [N]

std::vector<Unknown> first_of(const std::vector<Unknown>& order, std::size_t size) {
  return {order.begin(), order.begin() + static_cast<std::ptrdiff_t>(size)};
}

std::vector<FrontChain> chains_of(const Plan& plan) {
  std::vector<FrontChain> chains;
  for (const int seed : plan.seeds) {
    FrontChain& chain =
        chains.emplace_back(FrontChain{plan.main, {}, seed, plan.population, plan.generations});
    for (std::size_t k = plan.first_constants; k <= plan.order.size(); ++k) {
      chain.free.push_back(first_of(plan.order, k));
    }
  }
  for (const Interpretation& interpretation : plan.others) {
    chains.push_back({interpretation,
                      {first_of(plan.order, few_constants), plan.order},
                      plan.seeds.front(),
                      plan.population,
                      plan.generations});
  }
  return chains;
}

/// For every interpretation and number of parameters, all seeds together.
std::vector<Fit> points_of(const std::vector<ChainedFront>& fronts, const Worth& worth) {
  std::vector<Fit> fits;
  std::vector<bool> taken(fronts.size(), false);
  for (std::size_t i = 0; i < fronts.size(); ++i) {
    if (taken[i]) continue;
    std::vector<const ChainedFront*> alike;
    for (std::size_t j = i; j < fronts.size(); ++j) {
      const Parameterisation& a = fronts[i].parameterisation;
      const Parameterisation& b = fronts[j].parameterisation;
      if (a.interpretation != b.interpretation || a.free != b.free) continue;
      alike.push_back(&fronts[j]);
      taken[j] = true;
    }
    std::ranges::move(worth_judging(alike, worth), std::back_inserter(fits));
  }
  return fits;
}

Target error_target() {
  return {"threshold-error", true,
          [](const CoarseJudgement& j) { return goals_of(j).threshold_error; }};
}

Target worst_target() {
  return {"worst-threshold", true,
          [](const CoarseJudgement& j) { return goals_of(j).worst_threshold; }};
}

Target asked_target(const ClaimGroup& group) {
  return {"asked " + group.name, false,
          [group](const CoarseJudgement& j) { return loss_of_only(j, group); }};
}

const Fit& lowest_of(const std::vector<GoalFound>& found) {
  return std::ranges::min_element(found, {}, [](const GoalFound& f) { return f.whole.loss; })
      ->whole;
}

double range_of(const std::vector<GoalFound>& found) {
  const auto [lowest, highest] =
      std::ranges::minmax_element(found, {}, [](const GoalFound& f) { return f.whole.loss; });
  return highest->whole.loss - lowest->whole.loss;
}

/// The last front of each seed, with all parameters of the main interpretation.
std::vector<const ChainedFront*> last_fronts(const Results& results) {
  std::vector<const ChainedFront*> last;
  for (const ChainedFront& front : results.fronts) {
    const bool all = front.parameterisation.free.size() == results.plan.order.size();
    if (all && front.parameterisation.interpretation == results.plan.main) last.push_back(&front);
  }
  return last;
}

Fit best_by(const Target& target, std::vector<Fit> fits) {
  for (Fit& fit : fits) fit.loss = value_of(target, fit);
  return *std::ranges::min_element(fits, {}, &Fit::loss);
}

/// Searches from the best point of each seed's last front.
std::vector<GoalFound> found_from_fronts(const Target& target, const Results& results,
                                         FitStore& store) {
  std::vector<GoalSearch> searches;
  for (const ChainedFront* front : last_fronts(results)) {
    const Fit start = best_by(target, front->fits);
    searches.push_back({{start.interpretation, start.free, start.constants},
                        target,
                        results.plan.near,
                        front->seed,
                        results.plan.near_evaluations,
                        true});
  }
  return searched(searches, "thresholds alone, from the fronts", store);
}

/// The main interpretation with every solver and seed for both numbers, the others with the first
/// solver for the first number.
std::vector<LongSearches> planned_long_searches(const Plan& plan) {
  std::vector<LongSearches> all;
  const auto plan_for = [&](const Interpretation& interpretation, const Target& target,
                            const std::vector<Solver>& solvers) {
    LongSearches& one = all.emplace_back();
    one.interpretation = interpretation;
    one.target = target.name;
    for (const Solver& solver : solvers) {
      for (const int seed : plan.seeds) {
        one.searches.push_back({parameterisation_of(interpretation, plan.order), target, solver,
                                seed, plan.long_evaluations});
      }
    }
  };
  plan_for(plan.main, error_target(), plan.solvers);
  plan_for(plan.main, worst_target(), plan.solvers);
  for (const Interpretation& interpretation : plan.others) {
    plan_for(interpretation, error_target(), {plan.solvers.front()});
  }
  return all;
}

std::vector<LongSearches> long_searches(const Results& results, FitStore& store) {
  const Plan& plan = results.plan;
  std::vector<LongSearches> all = planned_long_searches(plan);
  std::vector<GoalSearch> searches;
  for (const LongSearches& one : all) {
    searches.insert(searches.end(), one.searches.begin(), one.searches.end());
  }
  const std::vector<GoalFound> found = searched(searches, "thresholds alone", store);
  std::vector<Fit> best;
  auto next = found.begin();
  for (LongSearches& one : all) {
    const auto end = next + static_cast<std::ptrdiff_t>(one.searches.size());
    one.found.assign(next, end);
    next = end;
    std::vector<GoalFound> ends = one.found;
    if (one.interpretation == plan.main) {
      one.from_fronts = found_from_fronts(one.searches.front().target, results, store);
      ends.insert(ends.end(), one.from_fronts.begin(), one.from_fronts.end());
    }
    best.push_back(lowest_of(ends));
  }
  const std::vector<Judged> judged_best = judged(best, plan.step);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].best = judged_best[i];
  return all;
}

std::vector<Asked> asked_alone(const Plan& plan, FitStore& store) {
  std::vector<Asked> all;
  std::vector<GoalSearch> searches;
  const std::size_t seeds = std::min<std::size_t>(2, plan.seeds.size());
  for (const ClaimGroup& group : asked_groups()) {
    all.push_back({group, {}, {}});
    for (std::size_t s = 0; s < seeds; ++s) {
      searches.push_back({parameterisation_of(plan.main, plan.order), asked_target(group),
                          plan.solvers.front(), plan.seeds[s], plan.asked_evaluations});
    }
  }
  const std::vector<GoalFound> found = searched(searches, "some claims alone", store);
  std::vector<Fit> best;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto first = found.begin() + static_cast<std::ptrdiff_t>(i * seeds);
    all[i].found.assign(first, first + static_cast<std::ptrdiff_t>(seeds));
    best.push_back(lowest_of(all[i].found));
  }
  const std::vector<Judged> judged_best = judged(best, plan.step);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].best = judged_best[i];
  return all;
}

/// The two best starts by all claims, best first, among the last fronts of the main interpretation
/// for each seed, with all parameters, and the searches for all claims.
std::vector<Fit> starts_of(const Results& results) {
  const Target all_claims = asked_target(asked_groups().back());
  std::vector<Fit> starts;
  for (const ChainedFront* front : last_fronts(results)) {
    starts.push_back(best_by(all_claims, front->fits));
  }
  for (const GoalFound& found : results.asked.back().found) starts.push_back(found.whole);
  std::ranges::stable_sort(starts, {}, &Fit::loss);
  starts.resize(2);
  return starts;
}

/// The evaluated point with the lowest loss of all claims among those of the main interpretation
/// with this number of parameters, or with more if there is none.
const Judged& nearest(const Results& results, std::size_t constants) {
  const Judged* best = nullptr;
  for (const Judged& point : results.points) {
    if (point.fit.interpretation != results.plan.main || point.fit.free.size() != constants)
      continue;
    if (best == nullptr || point.claims < best->claims) best = &point;
  }
  return best == nullptr ? results.asked.back().best : *best;
}

ResponseCurve curve_of(const std::string& name, const Fit& fit, const Response& response) {
  ResponseCurve curve{name, {}, {}};
  Case a_case = response.cases.front();
  const double last = response.cases.back().disturbance;
  for (int k = 0; k * curve_step <= last + 1e-9; ++k) {
    a_case.disturbance = k * curve_step;
    curve.disturbances.push_back(a_case.disturbance);
    curve.thresholds.push_back(
        coarse_score(fit.interpretation, fit.constants, a_case, finer).threshold);
  }
  return curve;
}

}  // namespace

double LongSearches::lowest() const {
  return best.fit.loss;
}

double LongSearches::apart() const {
  return range_of(found);
}

double LongSearches::fronts_apart() const {
  return from_fronts.empty() ? 0 : range_of(from_fronts);
}

Results limits(const Plan& plan, FitStore& store) {
  Results results;
  results.plan = plan;
  results.cases = cases_with_threshold();
  results.ordered = isotonic_bound(log_thresholds(results.cases), concluded_order(results.cases));
  results.responses = responses(results.cases);
  results.proportional = proportional_bound(results.responses, results.cases.size());
  results.indifferent =
      isotonic_bound(log_thresholds(results.cases), indifferent_order(results.cases));
  results.symmetries = check_symmetries(plan.main, symmetry_factor, plan.symmetry_draws, 1);
  results.fronts = searched_fronts(chains_of(plan), store);
  results.points = judged(points_of(results.fronts, plan.worth), plan.step);
  results.doubt = doubt_of(results.points);
  results.long_searches = long_searches(results, store);
  results.asked = asked_alone(plan, store);
  results.exclusion = exclusions(starts_of(results), plan.exclusion, store);
  results.grid = scanned_grid(nearest(results, few_constants).fit,
                              first_of(plan.order, scanned_constants), plan.grid_steps);
  const Response& response = results.responses.front();
  results.curves = {
      curve_of("least rms error", results.long_searches[0].best.fit, response),
      curve_of("least worst error", results.long_searches[1].best.fit, response),
      curve_of("nearest by all claims", nearest(results, plan.order.size()).fit, response)};
  return results;
}

}  // namespace ricochet::studies::limits
