#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ricochet/families.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// Pages that describe problems: one of all families, and one for each. `families` makes them when
/// the study runs. `scene_file` is the file of the machine whose problems they are, or empty.
Study problems_study(const std::function<std::vector<Family>()>& families,
                     const std::string& scene_file);

}  // namespace ricochet::studies
