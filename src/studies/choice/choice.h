#pragma once

#include <vector>

#include "src/report/results.h"
#include "src/report/site/study.h"
#include "src/studies/choice/cases.h"

namespace ricochet::studies::choice {

/// The choices of "auto" measured on each of these, in every setting: the tables rule, settings,
/// lines and families, the chart families, the value finding. Throws InputError if the
/// rule's choices were run in none of them.
report::Results measured_choices(const std::vector<Evidence>& evidence);

/// The same as a report.
Study choice_study(std::vector<Evidence> evidence);

}  // namespace ricochet::studies::choice
