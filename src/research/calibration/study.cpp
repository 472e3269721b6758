#include "src/studies/calibration/study.h"

#include <fmt/format.h>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "solvers/solvers.h"
#include "src/core/error.h"
#include "src/core/interruption.h"
#include "src/core/near_names.h"
#include "src/core/text_file.h"
#include "src/studies/calibration/results.h"

namespace ricochet::studies {
namespace {

using namespace calibration;

Solver solver_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
    known.push_back(solver.name);
  }
  for (const MissingSolver& missing : missing_solvers()) {
    if (missing.solver != name) continue;
    throw InputError(fmt::format("--solver {}: this build has no {}; allowed: {}", name,
                                 missing.library, fmt::join(known, ", ")));
  }
  throw InputError(
      fmt::format("--solver {}: there is no such solver; {}", name, what_instead(name, known)));
}

/// Throws InputError for options that allow none.
Plan plan_of(const CalibrationOptions& options, bool quick) {
  if (options.all_readings && !options.reading.empty()) {
    throw InputError("--all-readings stands alone: it takes no --reading");
  }
  if (options.seed < 0) {
    throw InputError(fmt::format("--seed {}: must be >= 0", options.seed));
  }
  const Search search{solver_named(options.solver), solver_named("ceres-trust-region"),
                      solver_named("nlopt-sbplx"), 0, options.seed};
  Plan plan = quick ? quick_plan(search) : full_plan(search);
  if (!options.all_readings) {
    plan.readings = {options.reading.empty() ? carrier_track::default_reading().reading
                                             : carrier_track::find_reading(options.reading)};
  }
  if (options.check) {
    Search reseeded = search;
    ++reseeded.seed;
    Search other = search;
    other.global = solver_named(options.solver == "nlopt-crs2" ? "pagmo-sade" : "nlopt-crs2");
    plan.checks = {std::move(reseeded), std::move(other)};
  }
  if (options.converge) {
    const auto convergence = quick ? quick_convergence : full_convergence;
    plan.convergence = convergence(solver_named("pagmo-sade"), solver_named("pagmo-de1220"));
  }
  return plan;
}

void write_reading(const Fit& fit, const CalibrationOptions& options) {
  const auto fitted = carrier_track::fitted_reading(
      fit.reading, fit.constants, fit.freed,
      fmt::format("ricochet calibrate{}{}{} --seed {} --solver {}",
                  options.all_readings ? " --all-readings" : " --reading ",
                  options.all_readings ? "" : name_of(fit.reading),
                  options.converge ? " --converge" : "", options.seed, options.solver),
      "the choice");
  write_text_file(options.folder / "reading.toml", write_fitted_reading(fitted));
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
    if (carrier_track::is_one_scene(choice.reading)) write_reading(choice, options);
    return data_of(results);
  };
  return {"calibration", "A first look, in half a minute", compute};
}

}  // namespace ricochet::studies
