#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <utility>

namespace ricochet {

/// A bracket of a root of f between a < b, where f has these values, as `is_narrow` demands or
/// after so many evaluations, by algorithm 748 of Alefeld, Potra and Shi
/// (DOI 10.1145/210089.210111). The whole of it where f does not change its sign there, which
/// rounding may cause.
template <class Function, class IsNarrow>
std::pair<double, double> bracketed_root(const Function& f, double a, double b, double at_a,
                                         double at_b, const IsNarrow& is_narrow,
                                         std::uintmax_t most_evaluations = 100) {
  const bool changes = (at_a <= 0 && at_b >= 0) || (at_a >= 0 && at_b <= 0);
  if (!changes || !(a < b)) return {a, b};
  return boost::math::tools::toms748_solve(f, a, b, at_a, at_b, is_narrow, most_evaluations);
}

}  // namespace ricochet
