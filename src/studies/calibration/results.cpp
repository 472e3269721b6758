#include "src/studies/calibration/results.h"

#include <algorithm>
#include <utility>

#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

/// Number of the best interpretations that are refined.
constexpr std::size_t finalists = 4;

RankedFit appraised(Fit fit, double step) {
  Appraisal appraisal = appraise(fit, step);
  return {std::move(fit), std::move(appraisal)};
}

std::vector<RankedFit> appraised(const std::vector<Fit>& fits, double step) {
  std::vector<RankedFit> ranked;
  for (const Fit& fit : fits) ranked.push_back(appraised(fit, step));
  return ranked;
}

double criterion_of(const RankedFit& r) {
  return r.appraisal.criterion;
}

void append(std::vector<Fit>& fits, const std::vector<Fit>& others) {
  fits.insert(fits.end(), others.begin(), others.end());
}

bool has(const std::vector<Fit>& fits, const Interpretation& interpretation) {
  return std::ranges::find(fits, interpretation, &Fit::interpretation) != fits.end();
}

/// Those whose cases share a scene: others are more expensive and cannot describe a user's machine.
std::vector<Fit> of_one_scene(const std::vector<Fit>& fits) {
  std::vector<Fit> some;
  std::ranges::copy_if(fits, std::back_inserter(some),
                       [](const Fit& f) { return is_one_scene(f.interpretation); });
  return some;
}

/// All parameters are free, and start there.
Fit start_of(const Interpretation& interpretation, const Constants& constants) {
  return {{interpretation, unknowns_of(interpretation), constants}};
}

std::vector<RankedFit> compared_interpretations(const Plan& plan, Searches& searches) {
  std::vector<Fit> starts;
  for (const Interpretation& r : plan.interpretations)
    starts.push_back(start_of(r, natural_constants()));
  std::vector<Fit> fits = searches.fits(starts, plan.search);
  for (int round = 0; round < 2 && plan.interpretations.size() > 1; ++round) {
    const std::vector<Fit> candidates = of_one_scene(fits);
    const Fit best = candidates.empty() ? fits.front() : best_of(candidates);
    starts.clear();
    for (const Interpretation& r : variations(best.interpretation)) {
      if (!has(fits, r)) starts.push_back(start_of(r, best.constants));
    }
    append(fits, searches.fits(starts, plan.search));
  }
  std::ranges::stable_sort(fits, {}, &Fit::loss);
  std::vector<Fit> best = of_one_scene(fits);
  best.resize(std::min(best.size(), finalists));
  for (const Fit& refined :
       searches.fits(best, with_evaluations(plan.search, plan.finalist_evaluations))) {
    *std::ranges::find(fits, refined.interpretation, &Fit::interpretation) = refined;
  }
  std::ranges::stable_sort(fits, {}, &Fit::loss);
  return appraised(fits, 5 * plan.step);
}

/// Returns the fit with the lowest criterion among the best few whose cases share a scene.
Fit most_sparing(const std::vector<RankedFit>& interpretations) {
  std::vector<RankedFit> candidates;
  for (const RankedFit& r : interpretations) {
    if (is_one_scene(r.fit.interpretation) && candidates.size() < finalists)
      candidates.push_back(r);
  }
  if (candidates.empty()) return interpretations.front().fit;
  return std::ranges::min_element(candidates, {}, criterion_of)->fit;
}

/// Fixes one more parameter at its natural value, the one that increases the loss least.
std::optional<Fit> with_one_held(const Fit& from, const Plan& plan, Searches& searches) {
  std::vector<Fit> starts;
  for (std::size_t i = 0; i < from.free.size(); ++i) {
    const auto which = static_cast<std::size_t>(from.free[i]);
    if (!unknown_parameters()[which].natural) continue;
    Fit& start = starts.emplace_back(from);
    start.free.erase(start.free.begin() + static_cast<std::ptrdiff_t>(i));
    start.constants[which] = *unknown_parameters()[which].natural;
  }
  if (starts.empty()) return std::nullopt;
  return best_of(searches.fits(starts, with_evaluations(plan.search, plan.pin_evaluations)));
}

std::vector<RankedFit> frontier_of(const Fit& best, const Plan& plan, Searches& searches) {
  std::vector<Fit> fits = {best};
  while (fits.back().free.size() > plan.fewest_constants) {
    auto next = with_one_held(fits.back(), plan, searches);
    if (!next) break;
    fits.push_back(std::move(*next));
  }
  return appraised(fits, plan.step);
}

bool is_default(const Parameterisation& parameterisation) {
  return parameterisation.interpretation == default_interpretation().interpretation &&
         parameterisation.free == default_interpretation().free;
}

/// The parameterisations that are searched at length in any case.
std::vector<Parameterisation> longest(const Results& results) {
  std::vector<Parameterisation> all = {forgotten(results.frontier[results.chosen].fit)};
  if (!is_default(all.front())) all.push_back(forgotten(default_interpretation()));
  const auto best = std::ranges::find_if(results.interpretations, [](const RankedFit& r) {
    return is_one_scene(r.fit.interpretation);
  });
  if (best != results.interpretations.end()) all.push_back(forgotten(best->fit));
  return all;
}

/// Returns an interpretation with the free parameters of the default one; the window's length is
/// free in its own unit.
Fit as_free_as_default(const Interpretation& interpretation) {
  const FittedInterpretation& usual = default_interpretation();
  const auto is_window = [](Unknown open) {
    return open == Unknown::revolutions || open == Unknown::seconds;
  };
  Fit fit{{interpretation, {}, forgotten(usual).constants}};
  for (const Unknown open : unknowns_of(interpretation)) {
    const bool free =
        is_window(open) ? std::ranges::any_of(usual.free, is_window) : contains(usual.free, open);
    if (free) fit.free.push_back(open);
  }
  return fit;
}

/// Those whose cases share a scene, the default one first, with its free parameters, sorted by the
/// losses of short searches.
std::vector<Parameterisation> best_as_free_as_default(const Results& results, Searches& searches) {
  const Interpretation& usual = default_interpretation().interpretation;
  std::vector<Interpretation> known = {usual};
  for (const RankedFit& r : results.interpretations) known.push_back(r.fit.interpretation);
  for (const Interpretation& r : variations(usual)) known.push_back(r);
  std::vector<Fit> starts;
  for (const Interpretation& r : known) {
    if (is_one_scene(r) && !has(starts, r)) starts.push_back(as_free_as_default(r));
  }
  std::vector<Fit> fits = searches.fits(starts, results.plan.search);
  std::ranges::stable_sort(fits.begin() + 1, fits.end(), {}, &Fit::loss);
  std::vector<Fit> best;
  for (const Fit& fit : fits) {
    if (best.size() == results.plan.long_searches->interpretations) break;
    const bool owes_nothing = std::ranges::any_of(best, [&](const Fit& better) {
      return loss({fit.interpretation, {}, better.constants}) == better.loss;
    });
    if (!owes_nothing) best.push_back(fit);
  }
  std::vector<Parameterisation> all;
  for (const Fit& fit : best) {
    if (!is_default(fit)) all.push_back(as_free_as_default(fit.interpretation));
  }
  return all;
}

std::vector<Convergence> converge(const std::vector<Parameterisation>& parameterisations,
                                  const LongSearches& plan, std::int64_t evaluations,
                                  Searches& searches) {
  std::vector<Convergence> all;
  for (std::vector<Fit>& fits :
       searches.from_random_points(parameterisations, plan.solvers, plan.seeds, evaluations)) {
    all.push_back({evaluations, std::move(fits)});
  }
  return all;
}

std::vector<Convergence> converged(const Results& results, Searches& searches) {
  const LongSearches& plan = *results.plan.long_searches;
  std::vector<Convergence> all = converge(longest(results), plan, plan.evaluations, searches);
  const std::vector<Parameterisation> others = best_as_free_as_default(results, searches);
  std::vector<Convergence> brief = converge(others, plan, plan.brief_evaluations, searches);
  std::vector<Parameterisation> open;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (!brief[i].agrees()) open.push_back(others[i]);
  }
  std::vector<Convergence> again = converge(open, plan, plan.evaluations, searches);
  auto next = again.begin();
  for (Convergence& one : brief) all.push_back(one.agrees() ? one : *next++);
  return all;
}

}  // namespace

std::vector<Fit> Convergence::as_good() const {
  constexpr double agreement = 0.01;
  std::vector<Fit> good;
  for (const Fit& fit : fits) {
    if (fit.loss <= (1 + agreement) * best_of(fits).loss) good.push_back(fit);
  }
  return good;
}

const RankedFit& Results::choice() const {
  if (converged.empty()) return frontier[chosen];
  return std::ranges::min_element(converged, {},
                                  [](const auto& fits) { return criterion_of(fits.front()); })
      ->front();
}

Results calibrate(const Plan& plan, Searches& searches) {
  Results results;
  results.plan = plan;
  results.interpretations = compared_interpretations(plan, searches);
  results.frontier = frontier_of(most_sparing(results.interpretations), plan, searches);
  results.chosen = static_cast<std::size_t>(
      std::ranges::min_element(results.frontier, {}, criterion_of) - results.frontier.begin());
  if (plan.long_searches) results.convergence = converged(results, searches);
  for (const Convergence& one : results.convergence) {
    results.converged.push_back(appraised(one.as_good(), plan.step));
    std::ranges::stable_sort(results.converged.back(), {}, criterion_of);
  }
  const FittedInterpretation& usual = default_interpretation();
  results.usual = appraised(Fit{usual, loss(usual)}, plan.step);
  const Fit& choice = results.choice().fit;
  results.predictions =
      predictions(choice, with_evaluations(plan.search, plan.left_out_evaluations),
                  plan.left_out_searches, plan.step, searches);
  results.profiles =
      profiles(choice, with_evaluations(plan.search, plan.profile_evaluations), searches);
  return results;
}

}  // namespace ricochet::studies::calibration
