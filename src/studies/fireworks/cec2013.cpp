#include <fmt/format.h>

#include <memory>
#include <pagmo/problems/cec2013.hpp>

#include "src/studies/fireworks/study.h"

namespace ricochet::studies::fireworks {
namespace {

/// -1400 for function 1, in steps of 100 without 0, to 1400 for function 28 (Liang, Qu, Suganthan
/// and Hernandez-Diaz, Technical Report 201212, Zhengzhou University, 2013).
double best_value(unsigned number) {
  return number <= 14 ? 100.0 * number - 1500 : 100.0 * number - 1400;
}

}  // namespace

Problem cec2013(unsigned number, unsigned n) {
  const auto function = std::make_shared<const pagmo::cec2013>(number, n);
  Problem problem;
  problem.name = fmt::format("cec2013-{}", number);
  problem.source = "CEC 2013, as pagmo has it";
  problem.lower = Vector::Constant(n, -100);
  problem.upper = Vector::Constant(n, 100);
  problem.start = Vector::Zero(n);
  problem.evaluate = [function, best = best_value(number)](const Vector& x) {
    return Values{function->fitness({x.begin(), x.end()})[0] - best, {}};
  };
  return problem;
}

}  // namespace ricochet::studies::fireworks
