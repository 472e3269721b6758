#include <dlib/global_optimization/global_function_search.h>

#include <algorithm>

#include "tests/solvers/direct_calls.h"

namespace ricochet {

Vector call_dlib(const DirectCall& call) {
  using Column = dlib::matrix<double, 0, 1>;
  const auto column = [](const Vector& from) {
    Column to(from.size());
    std::copy(from.begin(), from.end(), to.begin());
    return to;
  };
  const auto value = [&](const Column& u) {
    const Vector x = call.x(Eigen::Map<const Vector>(u.begin(), u.size()));
    return -call.evaluator.values(x)->objective;
  };
  const Column start = column(call.u(call.problem.start));
  const dlib::function_spec box(column(call.u(call.problem.lower)),
                                column(call.u(call.problem.upper)));
  dlib::global_function_search search({box}, {{{start, value(start)}}});
  search.set_seed(static_cast<std::time_t>(call.seed));
  for (int k = 1; k < call.limit; ++k) {
    dlib::function_evaluation_request request = search.get_next_x();
    request.set(value(request.x()));
  }
  Column best;
  double highest = 0;
  std::size_t of = 0;
  search.get_best_function_eval(best, highest, of);
  return call.x(Eigen::Map<const Vector>(best.begin(), best.size()));
}

}  // namespace ricochet
