#include "src/studies/calibration/results.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "src/studies/calibration/fit.h"
#include "src/studies/paper/interpretation.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

/// Number of the best interpretations that are refined.
constexpr std::size_t finalists = 4;

/// A compliant contact costs about 100 times as much as an impact.
constexpr std::int64_t compliant_price = 60;

FitTask interpretation_task(const Interpretation& interpretation, const Search& search,
                            const Constants& start) {
  const bool dear = interpretation.recovery == Recovery::contact_speed;
  return fit_task("fit", {interpretation, unknowns_of(interpretation), start},
                  with_evaluations(search, search.evaluations / (dear ? compliant_price : 1)));
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
  return a.loss < b.loss;
}

bool lower_criterion(const RankedFit& a, const RankedFit& b) {
  return a.appraisal.criterion < b.appraisal.criterion;
}

/// Returns the best fit whose cases share a scene: others are more expensive and cannot describe a
/// user's machine.
Fit best_scene(const std::vector<Fit>& fits) {
  const Fit* best = &fits.front();
  for (const Fit& f : fits) {
    if (!is_one_scene(f.interpretation)) continue;
    if (!is_one_scene(best->interpretation) || better(f, *best)) best = &f;
  }
  return *best;
}

/// Fits the variations of an interpretation that are not yet among the fits, from given parameters.
void add_variations(std::vector<Fit>& fits, const Interpretation& varied, const Constants& start,
                    const Search& search, FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Interpretation& r : variations(varied)) {
    const bool known = std::any_of(fits.begin(), fits.end(),
                                   [&](const Fit& fit) { return fit.interpretation == r; });
    if (!known) tasks.push_back(interpretation_task(r, search, start));
  }
  for (Fit& f : fits_by("fitting variations", tasks, store)) fits.push_back(std::move(f));
}

std::vector<Fit> fits_of(const std::vector<Interpretation>& interpretations, const Search& search,
                         FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Interpretation& r : interpretations)
    tasks.push_back(interpretation_task(r, search, natural_constants()));
  return fits_by("fitting interpretations", tasks, store);
}

/// Refines the best few whose cases share a scene, from their current parameters.
void refine_finalists(std::vector<Fit>& fits, const Plan& plan, FitStore& store) {
  std::stable_sort(fits.begin(), fits.end(), better);
  std::vector<FitTask> tasks;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < fits.size() && places.size() < finalists; ++i) {
    if (!is_one_scene(fits[i].interpretation)) continue;
    tasks.push_back(fit_task("final", {fits[i].interpretation, fits[i].free, fits[i].constants},
                             with_evaluations(plan.search, plan.finalist_evaluations)));
    places.push_back(i);
  }
  const auto refined = fits_by("fitting the best interpretations closely", tasks, store);
  for (std::size_t k = 0; k < places.size(); ++k) fits[places[k]] = refined[k];
  std::stable_sort(fits.begin(), fits.end(), better);
}

std::vector<RankedFit> compared_interpretations(const Plan& plan, FitStore& store) {
  std::vector<Fit> fits = fits_of(plan.interpretations, plan.search, store);
  if (fits.size() > 1) {
    for (int round = 0; round < 2; ++round) {
      const Fit best = best_scene(fits);
      add_variations(fits, best.interpretation, best.constants, plan.search, store);
    }
  }
  refine_finalists(fits, plan, store);
  return appraised(std::move(fits), 5 * plan.step);
}

/// Returns the fit with the lowest criterion among the best few whose cases share a scene.
Fit most_sparing(const std::vector<RankedFit>& interpretations) {
  std::vector<const RankedFit*> candidates;
  for (const RankedFit& r : interpretations) {
    if (is_one_scene(r.fit.interpretation) && candidates.size() < finalists)
      candidates.push_back(&r);
  }
  if (candidates.empty()) return interpretations.front().fit;
  return (*std::min_element(
              candidates.begin(), candidates.end(),
              [](const RankedFit* a, const RankedFit* b) { return lower_criterion(*a, *b); }))
      ->fit;
}

/// Fixes one more parameter at its natural value, the one that increases the loss least.
std::optional<Fit> with_one_held(const Fit& from, const Plan& plan, FitStore& store) {
  std::vector<FitTask> tasks;
  for (std::size_t i = 0; i < from.free.size(); ++i) {
    const auto which = static_cast<std::size_t>(from.free[i]);
    if (!unknown_parameters()[which].natural) continue;
    Parameterisation parameterisation{from.interpretation, from.free, from.constants};
    parameterisation.free.erase(parameterisation.free.begin() + static_cast<std::ptrdiff_t>(i));
    parameterisation.held[which] = *unknown_parameters()[which].natural;
    tasks.push_back(
        fit_task("pin", parameterisation, with_evaluations(plan.search, plan.pin_evaluations)));
  }
  if (tasks.empty()) return std::nullopt;
  const std::vector<Fit> fits = fits_by("holding one more constant", tasks, store);
  return *std::min_element(fits.begin(), fits.end(),
                           [](const Fit& a, const Fit& b) { return a.loss < b.loss; });
}

std::vector<RankedFit> frontier_of(const Fit& best, const Plan& plan, FitStore& store) {
  std::vector<Fit> fits = {best};
  while (fits.back().free.size() > plan.fewest_constants) {
    auto next = with_one_held(fits.back(), plan, store);
    if (!next) break;
    fits.push_back(std::move(*next));
  }
  return appraised(std::move(fits), plan.step);
}

RankedFit usual_interpretation(const Plan& plan) {
  const FittedInterpretation& usual = default_interpretation();
  Fit fit{usual.interpretation,
          usual.free,
          usual.constants,
          loss(usual.interpretation, usual.constants),
          {}};
  Appraisal appraisal = appraise(fit, plan.step);
  return {std::move(fit), std::move(appraisal)};
}

}  // namespace

Plan full_plan(const Search& search) {
  return {with_evaluations(search, 2400), 12000, 1600, 2400, 1, 100, 2, 0.01,
          core_interpretations()};
}

Plan quick_plan(const Search& search) {
  return {with_evaluations(search, 30), 60, 12, 12, 1, 6, 2, 0.1, core_interpretations()};
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
  results.interpretations = compared_interpretations(plan, store);
  results.frontier = frontier_of(most_sparing(results.interpretations), plan, store);
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
  results.usual = usual_interpretation(plan);
  const Fit& choice = results.choice().fit;
  results.predictions =
      predictions(choice, with_evaluations(plan.search, plan.left_out_evaluations),
                  plan.left_out_searches, plan.step, store);
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

namespace {

bool is_default(const Parameterisation& parameterisation) {
  return parameterisation.interpretation == default_interpretation().interpretation &&
         parameterisation.free == default_interpretation().free;
}

Parameterisation forgotten_fit(const Fit& fit) {
  return forgotten(fit.interpretation, fit.free, fit.constants);
}

std::vector<Parameterisation> longest(const Results& results) {
  const FittedInterpretation& usual = default_interpretation();
  std::vector<Parameterisation> parameterisations = {
      forgotten_fit(results.frontier[results.chosen].fit)};
  if (!is_default(parameterisations.front())) {
    parameterisations.push_back(forgotten(usual.interpretation, usual.free, usual.constants));
  }
  const auto best = std::ranges::find_if(results.interpretations, [](const RankedFit& r) {
    return is_one_scene(r.fit.interpretation);
  });
  if (best != results.interpretations.end()) parameterisations.push_back(forgotten_fit(best->fit));
  return parameterisations;
}

/// Returns an interpretation with the free parameters of the default one; the window's length is
/// free in its own unit.
Parameterisation as_free_as_default(const Interpretation& interpretation) {
  const FittedInterpretation& usual = default_interpretation();
  const auto is_window = [](Unknown open) {
    return open == Unknown::revolutions || open == Unknown::seconds;
  };
  Parameterisation parameterisation = forgotten(interpretation, usual.free, usual.constants);
  parameterisation.free.clear();
  for (const Unknown open : unknowns_of(interpretation)) {
    const bool free =
        is_window(open) ? std::ranges::any_of(usual.free, is_window) : contains(usual.free, open);
    if (free) parameterisation.free.push_back(open);
  }
  return parameterisation;
}

/// Returns all whose cases share a scene, including the default one.
std::vector<Interpretation> known_interpretations(const Results& results) {
  std::vector<Interpretation> interpretations;
  const auto add = [&](const Interpretation& r) {
    if (is_one_scene(r) && std::ranges::find(interpretations, r) == interpretations.end())
      interpretations.push_back(r);
  };
  add(default_interpretation().interpretation);
  for (const RankedFit& r : results.interpretations) add(r.fit.interpretation);
  for (const Interpretation& r : variations(default_interpretation().interpretation)) add(r);
  return interpretations;
}

/// Sorted by the losses of short searches, the default one first.
std::vector<Parameterisation> best_as_free_as_default(const Results& results, FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Interpretation& r : known_interpretations(results)) {
    tasks.push_back(fit_task("as free", as_free_as_default(r), results.plan.search));
  }
  std::vector<Fit> fits = fits_by("fitting interpretations of as many constants", tasks, store);
  std::ranges::stable_sort(fits, {}, [](const Fit& f) {
    return std::pair(f.interpretation != default_interpretation().interpretation, f.loss);
  });
  std::vector<Fit> best;
  for (const Fit& fit : fits) {
    if (best.size() == results.plan.convergence->interpretations) break;
    const bool owes_nothing = std::ranges::any_of(best, [&](const Fit& better) {
      return loss(fit.interpretation, better.constants) == better.loss;
    });
    if (!owes_nothing) best.push_back(fit);
  }
  std::vector<Parameterisation> parameterisations;
  for (const Fit& fit : best) {
    Parameterisation parameterisation = as_free_as_default(fit.interpretation);
    if (!is_default(parameterisation)) parameterisations.push_back(std::move(parameterisation));
  }
  return parameterisations;
}

/// Searches briefly, and again at length if the searches do not agree.
std::vector<Convergence> converged_by_turns(const std::vector<Parameterisation>& parameterisations,
                                            const ConvergencePlan& plan, FitStore& store) {
  ConvergencePlan brief = plan;
  brief.evaluations = plan.interpretation_evaluations;
  std::vector<Convergence> all = converge(parameterisations, brief, store);
  std::vector<Parameterisation> open;
  for (const Convergence& one : all) {
    if (!one.agreed_from()) open.push_back(one.parameterisation);
  }
  std::vector<Convergence> again = converge(open, plan, store);
  auto next = again.begin();
  for (Convergence& one : all) {
    if (!one.agreed_from()) one = std::move(*next++);
  }
  return all;
}

}  // namespace

std::vector<Convergence> long_searches(const Results& results, FitStore& store) {
  const ConvergencePlan& plan = *results.plan.convergence;
  std::vector<Convergence> all = converge(longest(results), plan, store);
  std::ranges::move(converged_by_turns(best_as_free_as_default(results, store), plan, store),
                    std::back_inserter(all));
  return all;
}

}  // namespace ricochet::studies::calibration
