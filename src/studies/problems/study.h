#pragma once

#include <string>

#include "src/studies/study.h"

namespace ricochet::studies {

/// What every question asks: a page of all families, and one for each, of the paper's cases and the
/// literature's problems; of the machine in a scene file instead, where one is given.
Study problems_study(const std::string& scene_file);

}  // namespace ricochet::studies
