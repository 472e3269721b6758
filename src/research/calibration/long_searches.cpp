#include "src/research/calibration/long_searches.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "src/research/calibration/fit_task.h"
#include "src/research/paper/fitted_interpretation.h"
#include "src/research/paper/loss.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

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
