#pragma once

#include "src/report/page.h"
#include "src/studies/calibration/study.h"

namespace ricochet::studies::calibration {

/// Every reading, ranked, and its error against the number of its constants.
report::Section reading_section(const Study& study);

/// What each answer to each of the paper's open questions costs.
report::Section answer_section(const Study& study);

/// The best reading with fewer and fewer constants, and which of these fits is chosen.
report::Section frontier_section(const Study& study);

/// Thresholds of cases that a fit has not seen.
report::Section prediction_section(const Study& study);

/// How well each constant is determined, and what each threshold owes to it.
report::Section constant_section(const Study& study);

/// Whether another seed and another solver rank the readings alike.
report::Section ranking_section(const Study& study);

/// Name of an open constant as people read it: "centrifugal mass radius".
std::string words_of(carrier_track::Open constant);

}  // namespace ricochet::studies::calibration
