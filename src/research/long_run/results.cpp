#include "src/research/long_run/results.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "ricochet/random.h"
#include "ricochet/solvers.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/core/progress.h"
#include "src/research/paper/fitted_interpretation.h"
#include "src/research/paper/loss.h"

namespace ricochet::studies::long_run {

using namespace carrier_track;
using calibration::CaseAppraisal;
using calibration::Fit;

namespace {

constexpr int resamples = 2000;
constexpr std::uint64_t seed = 1;
constexpr const char* few_parameters = "long-run";

double mean_root(double squares, std::size_t size) {
  return std::sqrt(squares / static_cast<double>(size));
}

std::vector<double> evenly(double from, double to, int parts) {
  std::vector<double> values;
  for (int k = 0; k <= parts; ++k) values.push_back(from + (to - from) * k / parts);
  return values;
}

UsualFit usual_fit(const Plan& plan) {
  const FittedInterpretation& usual = default_interpretation();
  UsualFit result;
  result.fit = {usual.interpretation, usual.free, usual.constants,
                loss(usual.interpretation, usual.constants), ""};
  result.appraisal = calibration::appraise(result.fit, plan.counts.step);
  const std::vector<Case> cases = cases_with_threshold();
  result.left_out.resize(cases.size());
  Progress progress("leaving one case out", static_cast<double>(cases.size()));
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    const Parameterisation parameterisation{usual.interpretation, usual.free, usual.constants};
    const Fit without = calibration::fit(parameterisation, plan.left_out, cases[i].id);
    const calibration::Appraisal appraisal = calibration::appraise(without, plan.counts.step);
    for (const CaseAppraisal& c : appraisal.cases) {
      if (c.the_case.id == cases[i].id) result.left_out[i] = error_of(c);
    }
    progress.advance(1);
  });
  return result;
}

template <class What, class Options>
auto all_fitted(const char* words, const std::vector<What>& all, const Options& plan) {
  std::vector<decltype(fitted(all.front(), plan))> fits(all.size());
  Progress progress(words, static_cast<double>(all.size()));
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    fits[i] = fitted(all[i], plan);
    progress.advance(1);
  });
  return fits;
}

/// More parameters begin at the best values of fewer.
std::vector<CountFit> fitted_counts(const CountPlan& plan) {
  const std::vector<CountInterpretation> all = count_interpretations();
  const auto fewer = std::ranges::find(
      all, few_parameters, [](const CountInterpretation& what) { return what.variant.name; });
  const CountFit first = fitted(*fewer, plan);
  std::vector<CountInterpretation> others;
  for (CountInterpretation what : all) {
    if (what.variant.name == few_parameters) continue;
    const bool extends = what.goal == Goal::loss && what.variant.base == fewer->variant.base &&
                         what.variant.free.size() > fewer->variant.free.size();
    if (extends) what.variant.start = first.fit.constants;
    others.push_back(std::move(what));
  }
  std::vector<CountFit> fits = all_fitted("fitting counts", others, plan);
  fits.insert(fits.begin() + (fewer - all.begin()), first);
  return fits;
}

}  // namespace

Plan full_plan() {
  const Solver global = solver_named("pagmo-sade");
  const Solver squares = solver_named("ceres-trust-region");
  const Solver local = solver_named("nlopt-sbplx");
  return {{{global, {}, local, 900}, 60, 0.02},
          {global, squares, local, 900, 20},
          {global, squares, local, 2400},
          evenly(0.05, 0.95, 18),
          evenly(0.05, 0.5, 9)};
}

Plan quick_plan() {
  Plan plan = full_plan();
  plan.counts = {{plan.counts.search.global, {}, plan.counts.search.local, 9}, 2, 1};
  plan.borders.evaluations = 30;
  plan.borders.polish_evaluations = 2;
  plan.left_out.evaluations = 6;
  plan.restitutions = {0.1, 0.3, 0.6, 0.9};
  plan.frictions = {0.1, 0.4};
  return plan;
}

RootMeanSquare root_mean_square(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  Random random(seed);
  std::vector<double> drawn;
  for (int k = 0; k < resamples; ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double error =
          errors[static_cast<std::size_t>(uniform(random) * static_cast<double>(errors.size()))];
      sum += error * error;
    }
    drawn.push_back(mean_root(sum, errors.size()));
  }
  return {mean_root(squares, errors.size()), {quantile(drawn, 0.025), quantile(drawn, 0.975)}};
}

Results long_run(const Plan& plan) {
  Results results;
  results.plan = plan;
  results.law = compared(default_interpretation().scene, plan.restitutions, plan.frictions);
  results.borders = all_fitted("fitting borders", border_interpretations(), plan.borders);
  results.counts = fitted_counts(plan.counts);
  results.usual = usual_fit(plan);
  return results;
}

}  // namespace ricochet::studies::long_run
