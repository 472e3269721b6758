#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "src/core/near_names.h"
#include "src/core/penalty.h"

namespace ricochet {

std::vector<Formulation> Problem::formulations(const std::vector<double>& smoothings) const {
  std::vector<double> all = {0};
  const auto add = [&](double s) {
    if (std::find(all.begin(), all.end(), s) == all.end()) all.push_back(s);
  };
  if (smoothed) {
    add(smoothing);
    for (const double s : smoothings) add(s);
  }
  std::vector<Formulation> formulations;
  for (const double s : all) {
    formulations.push_back({s});
    if (constraints > 0) formulations.push_back({s, true});
  }
  return formulations;
}

Problem Problem::formulated(const Formulation& formulation) const {
  if ((formulation.smoothing > 0 && !smoothed) || (formulation.penalised && constraints == 0)) {
    throw std::invalid_argument(fmt::format("{} has no formulation with smoothing {}{}", name,
                                            formulation.smoothing,
                                            formulation.penalised ? ", penalised" : ""));
  }
  Problem result = formulation.smoothing > 0 ? smoothed(formulation.smoothing) : *this;
  result.gradient_cost = gradient_cost;
  result.factors = factors;
  return formulation.penalised ? ricochet::penalised(result, penalty_weight) : result;
}

std::string Problem::name_of(const Formulation& formulation) const {
  if (!smoothed) return formulation.penalised ? "penalised" : "original";
  const std::string shown = formulation.smoothing == 0 ? "count"
                            : formulation.smoothing == smoothing
                                ? "surrogate"
                                : fmt::format("surrogate-{}", formulation.smoothing);
  return formulation.penalised ? "penalised-" + shown : shown;
}

Formulation Problem::formulation_named(const std::string& wanted) const {
  if (wanted.empty()) return {};
  std::vector<std::string> known;
  for (const Formulation& formulation : formulations()) {
    known.push_back(name_of(formulation));
    if (known.back() == wanted) return formulation;
  }
  throw InputError(
      fmt::format("{}: {} has no such formulation; {}", wanted, name, what_instead(wanted, known)));
}

}  // namespace ricochet
