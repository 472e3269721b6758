#include "src/studies/calibration/study.h"

#include <fmt/format.h>

#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/studies/calibration/findings.h"
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
                      solver_named("nlopt-sbplx"), 0, options.seed};
  Plan plan = quick ? quick_plan(search) : full_plan(search);
  if (!options.all_interpretations) {
    plan.interpretations = {options.interpretation.empty()
                                ? carrier_track::default_interpretation().interpretation
                                : carrier_track::find_interpretation(options.interpretation)};
  }
  if (options.converge) {
    const auto convergence = quick ? quick_convergence : full_convergence;
    plan.convergence = convergence(solver_named("pagmo-sade"), solver_named("pagmo-de1220"));
    if (!quick) {
      plan.left_out_evaluations = 25'000;
      plan.left_out_searches = 2;
    }
  }
  return plan;
}

void write_interpretation(const Fit& fit, const CalibrationOptions& options) {
  const auto fitted = carrier_track::fitted_interpretation(
      fit.interpretation, fit.constants, fit.free,
      fmt::format("ricochet calibrate{}{}{} --seed {} --solver {}",
                  options.all_interpretations ? " --all-interpretations" : " --interpretation ",
                  options.all_interpretations ? "" : name_of(fit.interpretation),
                  options.converge ? " --converge" : "", options.seed, options.solver),
      "the choice");
  write_text_file(options.folder / "interpretation.toml", write_fitted_interpretation(fitted),
                  SymbolicLinks::refused);
}

}  // namespace

Study calibration_study(const CalibrationOptions& options) {
  const auto compute = [options](bool quick) {
    const Plan plan = plan_of(options, quick);
    std::filesystem::create_directories(options.folder);
    const std::filesystem::path fits = options.folder / "fits.toml";
    FitStore store(fits);
    const AtInterruption kept(
        [] {},
        fmt::format("finished fits are kept in {}: the same command goes on", fits.string()));
    const Results results = calibrate(plan, store);
    const Fit& choice = results.choice().fit;
    if (carrier_track::is_one_scene(choice.interpretation)) write_interpretation(choice, options);
    return json_of(findings_of(results));
  };
  return {"calibration", "A first look, in half a minute", compute};
}

}  // namespace ricochet::studies
