#pragma once

/// @file
/// The families of problems.

#include <string>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// Problems of one kind. reports/templates/families.toml describes them.
struct Family {
  std::string name;  ///< what the names of its problems begin with, e.g. "top-speed"
  std::vector<Problem> problems;
};

/// Every family of problems: those of the paper's cases and of the literature. With a scene file,
/// those of its machine instead; throws InputError if the file is invalid.
std::vector<Family> all_families(const std::string& scene_file = "");

/// The problems of all families, in order.
std::vector<Problem> every_problem(const std::vector<Family>& families);

}  // namespace ricochet
