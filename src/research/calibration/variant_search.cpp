#include "src/research/calibration/variant_search.h"

#include <fmt/format.h>

#include "src/research/calibration/best_point.h"

namespace ricochet::studies::calibration {

using namespace carrier_track;
using namespace variants;

namespace {

/// Cost of an evaluation of a brief variant, in evaluations of the others.
constexpr double brief_price = 130;

Parameterisation base_parameterisation(const ModelVariant& variant) {
  return {variant.base, variant.free, start_of(variant).base};
}

}  // namespace

Problem variant_problem(const ModelVariant& variant) {
  Problem problem = calibration_problem(base_parameterisation(variant));
  // NOTE: the name seeds the search; the fits of the reference report used this one.
  problem.name = "trial-" + variant.name;
  problem.residuals = nullptr;
  const Eigen::Index of_base = problem.dimension();
  const Eigen::Index size = of_base + std::ssize(variant.own);
  problem.start.conservativeResize(size);
  for (Eigen::Index i = of_base; i < size; ++i) {
    const UnknownParameter& own = variant.own[static_cast<std::size_t>(i - of_base)];
    problem.variables.push_back({std::string(own.name), ""});
    problem.start[i] = share_of(own, own.natural.value());
  }
  problem.lower = Vector::Zero(size);
  problem.upper = Vector::Ones(size);
  problem.evaluate = [variant](const Vector& x) {
    return Values{loss_of(variant, constants_at(variant, x)), {}};
  };
  return problem;
}

VariantConstants constants_at(const ModelVariant& variant, const Vector& x) {
  VariantConstants constants{constants_at(base_parameterisation(variant), x), {}};
  auto i = std::ssize(variant.free);
  for (const UnknownParameter& own : variant.own) constants.own.push_back(value_at(own, x[i++]));
  return constants;
}

Fit fit(const ModelVariant& variant, const Search& search) {
  Problem problem = variant_problem(variant);
  problem.name += fmt::format("-seed-{}", search.seed);  // which alone decides about randomness
  BestPoint best = start_of(problem);
  improve(problem, search.global, search.evaluations * 2 / 3, best);
  improve(problem, search.local, search.evaluations / 3, best);
  const VariantConstants constants = constants_at(variant, best.x);
  return {variant.base, variant.free, constants.base, best.loss, "", constants.own};
}

FitTask fit_task(const ModelVariant& variant, const Search& search) {
  std::string options = options_of(search);
  for (const UnknownParameter& own : variant.own) {
    options += fmt::format(", {} {} to {} from {}", own.name, own.lower, own.upper, *own.natural);
  }
  AskedFit asked{
      fmt::format("model variant {} by {}, seed {}", variant.name, search.global.name, search.seed),
      base_parameterisation(variant), "", std::move(options),
      [variant](const Fit& found) { return loss_of(variant, variant_constants(found)); }};
  return {{std::move(asked)},
          [=] { return std::vector{fit(variant, search)}; },
          static_cast<double>(search.evaluations) * (variant.brief ? brief_price : 1)};
}

VariantConstants variant_constants(const Fit& fit) {
  return {fit.constants, fit.own};
}

}  // namespace ricochet::studies::calibration
