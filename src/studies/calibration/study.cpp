#include "src/studies/calibration/study.h"

#include <fmt/format.h>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/studies/calibration/results.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies {

namespace {

using namespace calibration;

/// Throws InputError for invalid options.
Plan plan_of(const CalibrationOptions& options, bool quick) {
  if (options.all_interpretations && !options.interpretation.empty()) {
    throw InputError("--all-interpretations stands alone: it takes no --interpretation");
  }
  if (options.seed < 0) {
    throw InputError(fmt::format("--seed {}: must be >= 0", options.seed));
  }
  const Search search{solver_named(options.solver, "--solver"), solver_named("ceres-trust-region"),
                      solver_named("nlopt-sbplx"), quick ? 30 : 2400, options.seed};
  Plan plan = quick ? Plan{search, 60, 12, 12, 1, 6, 2, 0.1}
                    : Plan{search, 12'000, 1600, 2400, 1, 100, 2, 0.01};
  if (options.all_interpretations) {
    plan.interpretations = carrier_track::core_interpretations();
  } else if (options.interpretation.empty()) {
    plan.interpretations = {carrier_track::default_interpretation().interpretation};
  } else {
    plan.interpretations = {carrier_track::find_interpretation(options.interpretation)};
  }
  if (!options.converge) return plan;
  const std::vector<Solver> solvers = {solver_named("pagmo-sade"), solver_named("pagmo-de1220")};
  plan.long_searches = quick ? LongSearches{solvers, {1, 2}, 40, 20, 3}
                             : LongSearches{solvers, {1, 2, 3}, 100'000, 25'000, 12};
  if (!quick) {
    plan.left_out_evaluations = 25'000;
    plan.left_out_searches = 2;
  }
  return plan;
}

void write_interpretation(const Fit& fit, const CalibrationOptions& options) {
  const std::string what = options.all_interpretations
                               ? " --all-interpretations"
                               : " --interpretation " + name_of(fit.interpretation);
  const auto fitted = carrier_track::fitted_interpretation(
      fit,
      fmt::format("ricochet calibrate{}{} --seed {} --solver {}", what,
                  options.converge ? " --converge" : "", options.seed, options.solver),
      "the choice");
  write_text_file(options.folder / "interpretation.toml", write_fitted_interpretation(fitted),
                  SymbolicLinks::refused);
}

}  // namespace

Study calibration_study(const CalibrationOptions& options, const Provenance& provenance) {
  const auto compute = [options, provenance](bool quick) {
    const Plan plan = plan_of(options, quick);
    std::filesystem::create_directories(options.folder);
    const std::filesystem::path runs = options.folder / "runs.sqlite";
    const AtInterruption kept(
        [] {},
        fmt::format("finished runs are kept in {}: the same command goes on", runs.string()));
    Searches searches(runs, provenance);
    const Results results = calibrate(plan, searches);
    const Fit& choice = results.choice().fit;
    if (carrier_track::is_one_scene(choice.interpretation)) write_interpretation(choice, options);
    return json_of(findings_of(results));
  };
  return {"calibration", "A first look, in half a minute", compute};
}

}  // namespace ricochet::studies
