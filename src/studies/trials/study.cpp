#include "src/studies/trials/study.h"

#include <fmt/format.h>

#include <stdexcept>

#include "solvers/solvers.h"
#include "src/core/interruption.h"
#include "src/studies/trials/results.h"

namespace ricochet::studies {
namespace {

using namespace trials;

Solver solver_called(const std::string& name) {
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
  }
  throw std::runtime_error("this build has no " + name);
}

}  // namespace

Study trials_study(const std::filesystem::path& folder) {
  const auto compute = [folder](bool quick) {
    const auto plan = quick ? quick_trial_plan : full_trial_plan;
    std::filesystem::create_directories(folder);
    const std::filesystem::path fits = folder / "fits.toml";
    TrialFitStore store(fits);
    const AtInterruption kept(
        [] {},
        fmt::format("finished fits are kept in {}: the same command goes on", fits.string()));
    return data_of(
        try_all(plan(solver_called("pagmo-cmaes-ipop"), solver_called("nlopt-sbplx")), store));
  };
  return {"trials", "A first look, in seconds", compute};
}

}  // namespace ricochet::studies
