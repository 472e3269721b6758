#include "src/studies/calibration/long_searches.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/misfit.h"
#include "src/studies/calibration/fit_task.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

bool is_default(const Freedom& freedom) {
  return freedom.reading == default_reading().reading && freedom.freed == default_reading().freed;
}

Freedom forgotten_fit(const Fit& fit) {
  return forgotten(fit.reading, fit.freed, fit.constants);
}

std::vector<Freedom> longest(const Results& results) {
  const FittedReading& usual = default_reading();
  std::vector<Freedom> freedoms = {forgotten_fit(results.frontier[results.chosen].fit)};
  if (!is_default(freedoms.front())) {
    freedoms.push_back(forgotten(usual.reading, usual.freed, usual.constants));
  }
  const auto best = std::ranges::find_if(
      results.readings, [](const RankedFit& r) { return is_one_scene(r.fit.reading); });
  if (best != results.readings.end()) freedoms.push_back(forgotten_fit(best->fit));
  return freedoms;
}

/// A reading that frees what the default one does; of the window its length, in whichever unit.
Freedom as_free_as_default(const Reading& reading) {
  const FittedReading& usual = default_reading();
  const auto is_window = [](Open open) {
    return open == Open::revolutions || open == Open::seconds;
  };
  Freedom freedom = forgotten(reading, usual.freed, usual.constants);
  freedom.freed.clear();
  for (const Open open : open_of(reading)) {
    const bool freed =
        is_window(open) ? std::ranges::any_of(usual.freed, is_window) : contains(usual.freed, open);
    if (freed) freedom.freed.push_back(open);
  }
  return freedom;
}

/// All whose cases share a scene, the default one among them.
std::vector<Reading> known_readings(const Results& results) {
  std::vector<Reading> readings;
  const auto add = [&](const Reading& r) {
    if (is_one_scene(r) && std::ranges::find(readings, r) == readings.end()) readings.push_back(r);
  };
  add(default_reading().reading);
  for (const RankedFit& r : results.readings) add(r.fit.reading);
  for (const Reading& r : variations(default_reading().reading)) add(r);
  return readings;
}

/// By the misfits of short searches, the default one first.
std::vector<Freedom> best_as_free_as_default(const Results& results, FitStore& store) {
  std::vector<FitTask> tasks;
  for (const Reading& r : known_readings(results)) {
    tasks.push_back({"as free", fit, as_free_as_default(r), results.plan.search});
  }
  std::vector<Fit> fits = done("fitting readings of as many constants", tasks, store);
  std::ranges::stable_sort(fits, {}, [](const Fit& f) {
    return std::pair(f.reading != default_reading().reading, f.misfit);
  });
  std::vector<Fit> best;
  for (const Fit& fit : fits) {
    if (best.size() == results.plan.convergence->readings) break;
    const bool owes_nothing = std::ranges::any_of(best, [&](const Fit& better) {
      return misfit(fit.reading, better.constants) == better.misfit;
    });
    if (!owes_nothing) best.push_back(fit);
  }
  std::vector<Freedom> freedoms;
  for (const Fit& fit : best) {
    Freedom freedom = as_free_as_default(fit.reading);
    if (!is_default(freedom)) freedoms.push_back(std::move(freedom));
  }
  return freedoms;
}

/// Searches briefly; where that does not agree, anew and at length.
std::vector<Convergence> converged_by_turns(const std::vector<Freedom>& freedoms,
                                            const ConvergencePlan& plan, FitStore& store) {
  ConvergencePlan brief = plan;
  brief.evaluations = plan.reading_evaluations;
  std::vector<Convergence> all = converge(freedoms, brief, store);
  std::vector<Freedom> open;
  for (const Convergence& one : all) {
    if (!one.agreed_from()) open.push_back(one.freedom);
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
