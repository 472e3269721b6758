#pragma once

#include "src/site/found_report.h"

namespace ricochet::site {

/// What it costs to compute a motion, and how wrong it then is: a list of views, each a scene with
/// every integrator at every control, or the levels of the model. A view has name, the axes' labels
/// and series of points {name, points: [[time, error], ...]}. Null where there is no report of it.
Json motion_data(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
