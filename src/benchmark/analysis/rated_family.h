#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "src/benchmark/analysis/rating.h"

namespace ricochet::comparison {

/// The entries of a family as they are ranked in a campaign's report, with the largest budget.
struct RatedFamily {
  std::string name;                                               ///< as the report has it
  std::size_t problems = 0;                                       ///< of the family
  std::int64_t budget = 0;                                        ///< evaluations per variable
  std::vector<Rating> ratings;                                    ///< best first, see rate()
  std::map<std::string, std::shared_ptr<const Targets>> targets;  ///< by problem
};

}  // namespace ricochet::comparison
