#include "src/studies/calibration/results.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/misfit.h"
#include "src/statistics/rank_correlation.h"
#include "src/studies/calibration/fit_task.h"
#include "src/studies/calibration/long_searches.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// So many of the best readings are fitted closely.
constexpr std::size_t finalists = 4;

/// A compliant contact costs about a hundred times an impact.
constexpr std::int64_t compliant_price = 60;

FitTask reading_task(const Reading& reading, const Search& search, const Constants& start) {
  Freedom freedom{reading, open_of(reading), start};
  const bool dear = reading.recovery == Recovery::contact_speed;
  return {"fit", fit, std::move(freedom),
          with_evaluations(search, search.evaluations / (dear ? compliant_price : 1))};
}

std::vector<RankedFit> appraised(std::vector<Fit> fits, double step) {
  std::vector<RankedFit> ranked;
  for (Fit& f : fits) {
    Appraisal appraisal = appraise(f, step);
    ranked.push_back({std::move(f), std::move(appraisal)});
  }
  return ranked;
}

bool better(const Fit& a, const Fit& b) {
  return a.misfit < b.misfit;
}

bool lower_criterion(const RankedFit& a, const RankedFit& b) {
  return a.appraisal.criterion < b.appraisal.criterion;
}

/// The best of the fits whose cases share a scene: others are dearer, and no machine of a user's.
Fit best_scene(const std::vector<Fit>& fits) {
  const Fit* best = &fits.front();
  for (const Fit& f : fits) {
    if (!is_one_scene(f.reading)) continue;
    if (!is_one_scene(best->reading) || better(f, *best)) best = &f;
  }
  return *best;
}

/// Fits the variations of a reading that the fits do not hold yet, from given constants on.
void add_variations(std::vector<Fit>& fits, const Reading& varied, const Constants& start,
                    const Search& search, FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Reading& r : variations(varied)) {
    const bool known =
        std::any_of(fits.begin(), fits.end(), [&](const Fit& fit) { return fit.reading == r; });
    if (!known) tasks.push_back(reading_task(r, search, start));
  }
  for (Fit& f : done("fitting variations", tasks, store)) fits.push_back(std::move(f));
}

std::vector<Fit> fits_of(const std::vector<Reading>& readings, const Search& search,
                         FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Reading& r : readings) tasks.push_back(reading_task(r, search, natural_constants()));
  return done("fitting readings", tasks, store);
}

/// Fits the best few whose cases share a scene once more and more closely, from where they are.
void refine_finalists(std::vector<Fit>& fits, const Plan& plan, FitStore& store) {
  std::stable_sort(fits.begin(), fits.end(), better);
  std::vector<FitTask> tasks;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < fits.size() && places.size() < finalists; ++i) {
    if (!is_one_scene(fits[i].reading)) continue;
    tasks.push_back({"final",
                     fit,
                     {fits[i].reading, fits[i].freed, fits[i].constants},
                     with_evaluations(plan.search, plan.finalist_evaluations)});
    places.push_back(i);
  }
  const auto refined = done("fitting the best readings closely", tasks, store);
  for (std::size_t k = 0; k < places.size(); ++k) fits[places[k]] = refined[k];
  std::stable_sort(fits.begin(), fits.end(), better);
}

std::vector<RankedFit> compared_readings(const Plan& plan, FitStore& store) {
  std::vector<Fit> fits = fits_of(plan.readings, plan.search, store);
  if (fits.size() > 1) {
    for (int round = 0; round < 2; ++round) {
      const Fit best = best_scene(fits);
      add_variations(fits, best.reading, best.constants, plan.search, store);
    }
  }
  refine_finalists(fits, plan, store);
  return appraised(std::move(fits), 5 * plan.step);
}

/// The same readings by each of the other searches, from the natural constants on.
std::vector<Ranking> rankings_of(const Results& results, const Plan& plan, FitStore& store) {
  std::vector<double> own;
  std::vector<Reading> readings;
  for (const RankedFit& r : results.readings) {
    if (r.fit.reading.recovery == Recovery::contact_speed) continue;
    own.push_back(r.fit.misfit);
    readings.push_back(r.fit.reading);
  }
  std::vector<Ranking> rankings;
  for (const Search& check : plan.checks) {
    Ranking& ranking = rankings.emplace_back();
    ranking.search = with_evaluations(check, plan.search.evaluations);
    for (const Fit& f : fits_of(readings, ranking.search, store)) {
      ranking.readings.push_back(f.reading);
      ranking.misfits.push_back(f.misfit);
    }
    ranking.rank_correlation = rank_correlation(own, ranking.misfits).value_or(0.0);
  }
  return rankings;
}

/// The fit with the lowest criterion among the best few whose cases share a scene.
Fit most_sparing(const std::vector<RankedFit>& readings) {
  std::vector<const RankedFit*> candidates;
  for (const RankedFit& r : readings) {
    if (is_one_scene(r.fit.reading) && candidates.size() < finalists) candidates.push_back(&r);
  }
  if (candidates.empty()) return readings.front().fit;
  return (*std::min_element(
              candidates.begin(), candidates.end(),
              [](const RankedFit* a, const RankedFit* b) { return lower_criterion(*a, *b); }))
      ->fit;
}

/// The fit with one constant more held at its natural value, the one that costs least.
std::optional<Fit> with_one_held(const Fit& from, const Plan& plan, FitStore& store) {
  std::vector<FitTask> tasks;
  for (std::size_t i = 0; i < from.freed.size(); ++i) {
    const auto which = static_cast<std::size_t>(from.freed[i]);
    if (!open_constants()[which].natural) continue;
    Freedom freedom{from.reading, from.freed, from.constants};
    freedom.freed.erase(freedom.freed.begin() + static_cast<std::ptrdiff_t>(i));
    freedom.held[which] = *open_constants()[which].natural;
    tasks.push_back(
        {"pin", fit, std::move(freedom), with_evaluations(plan.search, plan.pin_evaluations)});
  }
  if (tasks.empty()) return std::nullopt;
  const std::vector<Fit> fits = done("holding one more constant", tasks, store);
  return *std::min_element(fits.begin(), fits.end(),
                           [](const Fit& a, const Fit& b) { return a.misfit < b.misfit; });
}

std::vector<RankedFit> frontier_of(const Fit& best, const Plan& plan, FitStore& store) {
  std::vector<Fit> fits = {best};
  while (fits.back().freed.size() > plan.fewest_constants) {
    auto next = with_one_held(fits.back(), plan, store);
    if (!next) break;
    fits.push_back(std::move(*next));
  }
  return appraised(std::move(fits), plan.step);
}

RankedFit usual_reading(const Plan& plan) {
  const FittedReading& usual = default_reading();
  Fit fit{usual.reading, usual.freed, usual.constants, misfit(usual.reading, usual.constants), ""};
  Appraisal appraisal = appraise(fit, plan.step);
  return {std::move(fit), std::move(appraisal)};
}

/// A fit as free as the choice that has not seen a case. The search begins at the choice, so that
/// it does not fail for want of time, and is over the whole of the bounds.
std::vector<Prediction> predictions_of(const Fit& choice, const Plan& plan, FitStore& store) {
  std::vector<FitTask> tasks;
  std::vector<Prediction> predictions;
  const Freedom freedom{choice.reading, choice.freed, choice.constants};
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    tasks.push_back(
        {"left out", fit, freedom, with_evaluations(plan.search, plan.left_out_evaluations), c.id});
    predictions.push_back({c.id, *c.claim.threshold, std::nullopt});
  }
  const std::vector<Fit> fits = done("leaving one case out", tasks, store);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const Appraisal appraisal = appraise(fits[i], plan.step);
    for (const CaseAppraisal& c : appraisal.cases) {
      if (c.the_case.id == predictions[i].case_id) predictions[i].predicted = c.score.threshold;
    }
  }
  return predictions;
}

}  // namespace

Plan full_plan(const Search& search) {
  return {with_evaluations(search, 2400), 12000, 1600, 2400, 100, 2, {}, 0.01, core_readings()};
}

Plan quick_plan(const Search& search) {
  return {with_evaluations(search, 30), 60, 12, 12, 6, 2, {}, 0.1, core_readings()};
}

ConvergencePlan full_convergence(const Solver& one, const Solver& other) {
  return {{one, other}, {1, 2, 3}, 100000, 25000, 12};
}

ConvergencePlan quick_convergence(const Solver& one, const Solver& other) {
  return {{one, other}, {1, 2}, 40, 20, 3};
}

Results calibrate(const Plan& plan, FitStore& store) {
  Results results;
  results.plan = plan;
  results.readings = compared_readings(plan, store);
  if (results.readings.size() > 1) results.rankings = rankings_of(results, plan, store);
  results.frontier = frontier_of(most_sparing(results.readings), plan, store);
  const auto lowest =
      std::min_element(results.frontier.begin(), results.frontier.end(), lower_criterion);
  results.chosen = static_cast<std::size_t>(lowest - results.frontier.begin());
  if (plan.convergence) {
    results.convergence = long_searches(results, store);
    for (const Convergence& one : results.convergence) {
      std::vector<RankedFit>& fits = results.converged.emplace_back();
      fits = appraised(one.as_good(), plan.step);
      std::stable_sort(fits.begin(), fits.end(), lower_criterion);
    }
  }
  results.usual = usual_reading(plan);
  const Fit& choice = results.choice().fit;
  results.predictions = predictions_of(choice, plan, store);
  results.sensitivities = sensitivities(choice, plan.step);
  results.profiles = profiles(choice, with_evaluations(plan.search, plan.profile_evaluations));
  return results;
}

const RankedFit& Results::choice() const {
  if (converged.empty()) return frontier[chosen];
  return std::min_element(
             converged.begin(), converged.end(),
             [](const auto& a, const auto& b) { return lower_criterion(a.front(), b.front()); })
      ->front();
}

double prediction_error(const std::vector<Prediction>& predictions) {
  double squares = 0;
  for (const Prediction& p : predictions) {
    squares += std::pow(p.predicted ? std::log(*p.predicted / p.paper) : std::log(2.0), 2);
  }
  return std::sqrt(squares / static_cast<double>(predictions.size()));
}

}  // namespace ricochet::studies::calibration
