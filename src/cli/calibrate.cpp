#include "src/cli/calibrate.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "solvers/solvers.h"
#include "src/core/error.h"
#include "src/core/text_file.h"
#include "src/report/file_set.h"
#include "src/studies/calibration/page.h"

namespace ricochet::cli {
namespace {

using namespace studies::calibration;

Solver solver_named(const std::string& name) {
  std::string known;
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
    known += (known.empty() ? "" : ", ") + solver.name;
  }
  throw InputError(fmt::format("--solver {}: there is no such solver; allowed: {}", name, known));
}

void print_row(const std::string& name, const RankedFit& r) {
  const Appraisal& a = r.appraisal;
  fmt::print(
      "{:<58} {:>2} {:>8.2f} {:>6.1f} %  {:>2}/10  {:>2}/10 {:>6.2f} {:>6.1f} %  {:>5.2f}  "
      "{:>2}/20 {:>7.1f}\n",
      name, r.fit.freed.size(), r.fit.misfit, 100 * a.threshold_error, a.within, a.exact_counts,
      a.purity, 100 * a.misclassified, a.loudness, a.right_examples, a.criterion);
}

void print(const Study& study) {
  fmt::print("{:<58} {:>2} {:>8} {:>8} {:>6} {:>6} {:>6} {:>8} {:>6} {:>6} {:>7}\n", "reading", "k",
             "misfit", "rms", "<5 %", "counts", "purity", "misclass", "loud", "right", "AICc");
  for (const RankedFit& r : study.readings) print_row(name_of(r.fit.reading), r);
  fmt::print("\nThe best reading, with fewer and fewer constants:\n");
  for (const RankedFit& r : study.frontier) {
    std::string held;
    for (const auto open : open_of(r.fit.reading)) {
      if (contains(r.fit.freed, open)) continue;
      held +=
          fmt::format(" {}", carrier_track::open_constants()[static_cast<std::size_t>(open)].name);
    }
    print_row(held.empty() ? "nothing held" : "held:" + held, r);
  }
}

}  // namespace

int calibrate(const CalibrateOptions& options) {
  if (options.all_readings && !options.reading.empty()) {
    throw InputError("--all-readings stands alone: it takes no --reading");
  }
  if (options.seed < 0) {
    throw InputError(fmt::format("--seed {}: must be >= 0", options.seed));
  }
  const Search search{solver_named(options.solver), solver_named("ceres-trust-region"),
                      solver_named("nlopt-sbplx"), 0, options.seed};
  Plan plan = options.quick ? quick_plan(search) : full_plan(search);
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
  report::require_writable(options.out);
  std::filesystem::create_directories(options.out);
  FitStore store(std::filesystem::path(options.out) / "fits.toml");
  const Study study = make_study(plan, store);
  report::write_page(page_of(study), options.out);
  const Fit& choice = study.choice().fit;
  print(study);
  if (carrier_track::is_one_scene(choice.reading)) {
    const auto fitted = carrier_track::fitted_reading(
        choice.reading, choice.constants, choice.freed,
        fmt::format("ricochet calibrate{}{} --seed {} --solver {}",
                    options.all_readings ? " --all-readings" : " --reading ",
                    options.all_readings ? "" : name_of(choice.reading), options.seed,
                    options.solver),
        "the choice");
    write_text_file(std::filesystem::path(options.out) / "reading.toml",
                    write_fitted_reading(fitted));
  }
  fmt::print("\nThresholds that a fit has not seen are {:.1f} % off; {:.0f} s\n",
             100 * prediction_error(study.predictions), study.seconds);
  fmt::print("The report: {}\n",
             (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
  return 0;
}

}  // namespace ricochet::cli
