#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "src/experiment/campaign.h"

namespace ricochet::studies {

/// All problems and solvers of the suite, the user's solvers, and grids of machines around the
/// paper's cases.
Catalogue whole_catalogue();

}  // namespace ricochet::studies

namespace ricochet {

/// Every family of problems of the suite: those of all_families(), the calibration of the
/// paper's default interpretation, and pathological problems. With a scene file, "-" for standard
/// input, the families of its machine instead, after each of `settings`, such as "friction=0.3",
/// has changed it. Throws InputError if the file or a setting is invalid, or for settings without a
/// file.
std::vector<Family> suite_families(const std::string& scene_file = "",
                                   const std::vector<std::string>& settings = {});

}  // namespace ricochet
