#include "src/studies/trials/trial_search.h"

#include <fmt/format.h>

#include "src/core/seed.h"
#include "src/studies/calibration/best_point.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

namespace {

const OpenConstant& of_base(Open open) {
  return open_constants()[static_cast<std::size_t>(open)];
}

Vector point_of(const Trial& trial, const TrialConstants& constants) {
  std::vector<double> x;
  for (const Open open : trial.freed) {
    x.push_back(share_of(of_base(open), constants.base[static_cast<std::size_t>(open)]));
  }
  for (std::size_t i = 0; i < trial.own.size(); ++i) {
    x.push_back(share_of(trial.own[i], constants.own[i]));
  }
  return Eigen::Map<const Vector>(x.data(), std::ssize(x));
}

}  // namespace

Problem trial_problem(const Trial& trial) {
  Problem problem;
  problem.name = "trial-" + trial.name;
  problem.source = "distance from the paper's claims, section 3.3, over the constants of a trial";
  for (const Open open : trial.freed) {
    problem.variables.push_back({std::string(of_base(open).name), ""});
  }
  for (const OpenConstant& own : trial.own)
    problem.variables.push_back({std::string(own.name), ""});
  problem.start = point_of(trial, start_of(trial));
  problem.lower = Vector::Zero(problem.start.size());
  problem.upper = Vector::Ones(problem.start.size());
  problem.evaluate = [trial](const Vector& x) {
    return Values{misfit_of(trial, constants_at(trial, x)), {}};
  };
  return problem;
}

TrialConstants constants_at(const Trial& trial, const Vector& x) {
  TrialConstants constants = start_of(trial);
  Eigen::Index i = 0;
  for (const Open open : trial.freed) {
    constants.base[static_cast<std::size_t>(open)] = value_at(of_base(open), x[i++]);
  }
  for (std::size_t k = 0; k < trial.own.size(); ++k) {
    constants.own[k] = value_at(trial.own[k], x[i++]);
  }
  return constants;
}

TrialFit fit(const Trial& trial, const TrialSearch& search) {
  Problem problem = trial_problem(trial);
  problem.name += fmt::format("-seed-{}", search.seed);  // which alone decides about randomness
  calibration::BestPoint best = calibration::start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  improve(problem, search.local, search.evaluations / 3, best);
  return {constants_at(trial, best.x), best.misfit};
}

std::string key_of(const Trial& trial, const TrialSearch& search) {
  std::string text = fmt::format("{} {} {} {} {}", trial.name, search.global.name,
                                 search.local.name, search.evaluations, search.seed);
  const Problem problem = trial_problem(trial);
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    text += fmt::format(" {} {}", problem.variables[static_cast<std::size_t>(i)].name,
                        problem.start[i]);
  }
  const TrialConstants start = start_of(trial);
  for (const double value : start.base) text += fmt::format(" {}", value);
  for (const OpenConstant& own : trial.own) text += fmt::format(" {} {}", own.lower, own.upper);
  return fmt::format("{} {} {} {:016x}", trial.name, search.global.name, search.seed,
                     seed_of(text, "", 0, 0));
}

}  // namespace ricochet::studies::trials
