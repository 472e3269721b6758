#pragma once

#include <string>
#include <vector>

#include "problems/family.h"

namespace ricochet {

/// Every family of questions that there is: of the paper's cases and of the literature. Where a
/// scene file is named, those of its machine instead; throws InputError for a file that is none.
std::vector<Family> all_families(const std::string& scene_file = "");

/// Their questions, one after the other.
std::vector<Question> every_question(const std::vector<Family>& families);

}  // namespace ricochet
