#include "src/research/long_run/count_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/problems/speed_range.h"
#include "src/research/calibration/best_point.h"
#include "src/research/long_run/per_turn.h"
#include "src/research/paper/fitted_interpretation.h"
#include "src/research/paper/loss.h"

namespace ricochet::studies::long_run {

using namespace carrier_track;
using calibration::CaseAppraisal;
using calibration::Fit;
using variants::EarlyStopping;
using variants::ModelVariant;
using variants::VariantConstants;

namespace {

constexpr double purity_weight = 1000;  // dearer than all claims

/// The count at a speed: the turns of the window times the collisions a turn.
CountAt count_of(const Case& a_case, const Interpretation& base, const Constants& constants,
                 const EarlyStopping& stopping) {
  const double turns = constants[static_cast<std::size_t>(Unknown::revolutions)];
  return [scene = scene_of(a_case, base, constants), turns, most = stopping.most](double omega) {
    const Scene there = at_speed(scene, omega);
    if (most != variants::searching.most) {
      return static_cast<int>(std::lround(turns * collisions_per_turn(there)));
    }
    const long count = std::lround(turns * brief_collisions_per_turn(there, most));
    return static_cast<int>(std::min<long>(count, most + 1));
  };
}

ModelVariant variant_of(std::string name, std::string description, const Interpretation& base,
                        std::vector<Unknown> free) {
  ModelVariant variant{std::move(name), std::move(description), base, std::move(free), {}};
  variant.start = default_interpretation().constants;
  variant.counts = [base](const Case& a_case, const VariantConstants& constants,
                          const EarlyStopping& stopping) {
    return count_of(a_case, base, constants.base, stopping);
  };
  return variant;
}

CountsOf brief_counts(const ModelVariant& variant, const VariantConstants& constants) {
  return [&](const Case& a_case, const std::vector<double>& speeds) {
    const CountAt count = variant.counts(a_case, constants, variants::searching);
    std::vector<int> counts;
    for (const double omega : speeds) counts.push_back(count(omega));
    return counts;
  };
}

/// How far the purities are below the goal, summed.
double impurity(const CountsOf& counts, const std::string& left_out) {
  double sum = 0;
  for (const Case& a_case : all_cases()) {
    if (!a_case.claim.threshold || a_case.id == left_out) continue;
    sum += std::max(0.0, purity_goal - coarse_score(counts, a_case).purity);
  }
  return sum;
}

Problem problem_of(const CountInterpretation& what, const std::string& left_out) {
  Problem problem = calibration::variant_problem(what.variant);
  problem.evaluate = [what, left_out](const Vector& x) {
    const VariantConstants constants = calibration::constants_at(what.variant, x);
    const CountsOf counts = brief_counts(what.variant, constants);
    double value = loss(counts, left_out);
    if (what.goal == Goal::purity) value += purity_weight * impurity(counts, left_out);
    return Values{value, {}};
  };
  return problem;
}

Fit fit_at(const ModelVariant& variant, const calibration::BestPoint& best,
           const std::string& left_out) {
  return {variant.base, variant.free, calibration::constants_at(variant, best.x).base, best.loss,
          left_out};
}

/// ln(threshold / paper) of a case, with exact counts.
double error_at(const ModelVariant& variant, const Constants& constants, const Case& a_case,
                double step) {
  const CountAt count = variant.counts(a_case, {constants, {}}, variants::judging);
  const SpeedScan scan = scan_speeds(count, step, fastest_speed);
  return error_of({a_case, scan, score(count, a_case.claim, scan, 1)});
}

}  // namespace

double error_of(const CaseAppraisal& judged) {
  const bool loud = judged.scan.counts.front() > quiet_limit(judged.score.quiet_count);
  const double end = loud ? judged.scan.step : fastest_speed;
  return std::log(judged.score.threshold.value_or(end) / *judged.the_case.claim.threshold);
}

std::vector<Case> cases_with_threshold() {
  std::vector<Case> cases = all_cases();
  std::erase_if(cases, [](const Case& c) { return !c.claim.threshold; });
  return cases;
}

std::vector<CountInterpretation> count_interpretations() {
  const FittedInterpretation& usual = default_interpretation();
  const std::vector<Unknown> three = {Unknown::centrifugal_mass_radius, Unknown::clearance,
                                      Unknown::counting_limit};
  std::vector<Unknown> four = three, six = three;
  four.push_back(Unknown::revolutions);
  six.insert(six.end(), {Unknown::revolutions, Unknown::normal_force, Unknown::pull});
  Interpretation plain = usual.interpretation;
  plain.normal_force = NormalForce::constant;
  ModelVariant one_turn = variant_of("long-run-one-turn", "Collisions a turn in the long run.",
                                     usual.interpretation, three);
  (*one_turn.start)[static_cast<std::size_t>(Unknown::revolutions)] = 1;
  const ModelVariant window =
      variant_of("long-run", "Collisions of a window of the long run.", usual.interpretation, four);
  ModelVariant purest = variant_of("long-run-pure", "The same, with a purity of 90 % first.",
                                   usual.interpretation, six);
  // Half a turn has one collision, which silence differs from by no more than a pure count may.
  (*purest.start)[static_cast<std::size_t>(Unknown::revolutions)] = 0.5;
  return {{one_turn},
          {window},
          {variant_of("long-run-6", "The same, with normal force and pull fitted.",
                      usual.interpretation, six)},
          {variant_of("long-run-plain-6", "The same, without friction of the walls' own force.",
                      plain, six)},
          {purest, Goal::purity}};
}

CountFit fitted(const CountInterpretation& what, const CountPlan& plan) {
  Problem problem = problem_of(what, "");
  calibration::BestPoint best = calibration::start_of(problem);
  calibration::improve(problem, plan.search.global, plan.search.evaluations * 2 / 3, best);
  calibration::improve(problem, plan.search.local, plan.search.evaluations / 3, best);
  CountFit result{what, fit_at(what.variant, best, ""), 0, {}, {}};
  result.loss = variants::loss_of(what.variant, {result.fit.constants, {}});
  const int free = static_cast<int>(what.variant.free.size());
  const auto counts = [&](const Case& a_case) {
    return what.variant.counts(a_case, {result.fit.constants, {}}, variants::judging);
  };
  result.appraisal = calibration::summed_up(calibration::judged(counts, plan.step), free);

  const std::vector<Case> cases = cases_with_threshold();
  result.left_out.resize(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    Problem others = problem_of(what, cases[i].id);
    calibration::BestPoint there{best.x, others.evaluate(best.x).objective};
    calibration::improve(others, plan.search.local, plan.left_out_evaluations, there);
    const Constants constants = calibration::constants_at(what.variant, there.x).base;
    result.left_out[i] = error_at(what.variant, constants, cases[i], plan.step);
  });
  return result;
}

}  // namespace ricochet::studies::long_run
