#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/analysis/rating.h"

namespace ricochet::exports {

/// A family of two problems with so many ranked entries, and one that is not ranked.
inline comparison::RatedFamily rated(const std::string& family, int entries) {
  comparison::RatedFamily made;
  made.name = family;
  made.problems = 2;
  made.budget = 100;
  for (int k = 0; k <= entries; ++k) {
    comparison::Rating& rating = made.ratings.emplace_back();
    rating.solver = "solver_" + std::to_string(k);
    rating.formulation = "original";
    rating.problems = k < entries ? 2 : 0;
    rating.returned = 1.0 / (k + 1);
    rating.found = 1;
    rating.progress = {{1, 0.25, {0.1, 0.5}}, {100, 0.5, {0.2, 0.8}}};
    if (k == entries) continue;
    rating.rank = k + 1.25;
    rating.probability_of_being_best = k == 0 ? 0.75 : 0.125;
  }
  made.targets["hs-1"] = std::make_shared<const comparison::Targets>(comparison::Targets{0.5, 1.5});
  return made;
}

}  // namespace ricochet::exports
