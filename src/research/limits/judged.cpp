#include "src/research/limits/judged.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "src/core/progress.h"
#include "src/research/limits/claims.h"

namespace ricochet::studies::limits {
namespace {

Judged judge_one(const Fit& fit, double step) {
  const CoarseJudgement coarse = judged_coarsely(fit.interpretation, fit.constants);
  Judged result{fit, goals_of(coarse), loss_without(coarse, {}), calibration::appraise(fit, step)};
  result.fine.cases.clear();
  return result;
}

}  // namespace

void to_json(report::Json& json, const Judged& point) {
  json = {{"interpretation", carrier_track::name_of(point.fit.interpretation)},
          {"constants", point.fit.free.size()},
          {"claims", point.claims}};
  json.update(report::Json(point.fine));
}

std::vector<Judged> judged(const std::vector<Fit>& fits, double step) {
  std::vector<Judged> all(fits.size());
  Progress progress("judging what was found", static_cast<double>(fits.size()));
  tbb::parallel_for(std::size_t{0}, fits.size(), [&](std::size_t i) {
    all[i] = judge_one(fits[i], step);
    progress.advance(1);
  });
  return all;
}

CoarseDoubt doubt_of(const std::vector<Judged>& points) {
  CoarseDoubt doubt;
  std::vector<double> errors;
  for (const Judged& p : points) {
    ++doubt.points;
    errors.push_back(std::abs(p.coarse.threshold_error - p.fine.threshold_error));
    doubt.largest_purity =
        std::max(doubt.largest_purity, std::abs(1 - p.coarse.impurity - p.fine.purity));
    doubt.other_counts += p.coarse.counts_missed == p.counts_missed() ? 0 : 1;
    doubt.other_examples += p.coarse.examples_missed == p.examples_missed() ? 0 : 1;
  }
  if (errors.empty()) return doubt;
  std::ranges::sort(errors);
  doubt.median_error = errors[errors.size() / 2];
  doubt.largest_error = errors.back();
  return doubt;
}

std::vector<Fit> worth_judging(const std::vector<const ChainedFront*>& fronts, const Worth& worth) {
  struct Seen {
    const Fit* fit;
    Vector goals;
  };
  std::vector<Seen> seen;
  for (const ChainedFront* front : fronts) {
    for (std::size_t i = 0; i < front->fits.size(); ++i) {
      GoalValues goals = front->goals[i];
      if (goals.examples_missed > worth.examples_missed || goals.threshold_error > worth.error) {
        continue;
      }
      goals.count_distance = 0;
      seen.push_back({&front->fits[i], goal_vector(goals)});
    }
  }
  std::vector<Fit> fits;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    bool worse = false;
    for (std::size_t j = 0; j < seen.size() && !worse; ++j) {
      worse = dominates(seen[j].goals, seen[i].goals) || (j < i && seen[j].goals == seen[i].goals);
    }
    if (!worse) fits.push_back(*seen[i].fit);
  }
  return fits;
}

std::vector<Pair> best_pairs(std::vector<Pair> pairs) {
  std::ranges::sort(pairs);
  std::vector<Pair> best;
  for (const Pair& pair : pairs) {
    if (best.empty() || pair.second < best.back().second) best.push_back(pair);
  }
  return best;
}

}  // namespace ricochet::studies::limits
