#pragma once

#include <string>

#include "src/experiment/plan.h"
#include "tests/experiment/campaign/made_up_catalogue.h"

namespace ricochet {

inline Campaign campaign_of(const std::string& plan) {
  return {plan_from(plan, "test"), made_up_catalogue()};
}

/// A part with what it cannot do without, unless the rest has it.
inline std::string part_of(const std::string& problems, const std::string& rest = "") {
  return "[[part]]\nproblems = " + problems +
         (rest.find("solvers") == std::string::npos ? "\nsolvers = \"chance-a\"" : "") +
         (rest.find("budgets") == std::string::npos ? "\nbudgets = 10" : "") + "\n" + rest + "\n";
}

}  // namespace ricochet
