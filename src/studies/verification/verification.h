#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/check/oracle.h"
#include "src/report/site/study.h"
#include "src/report/table.h"

namespace ricochet::studies {

struct VerificationOptions {
  int scenes = 10000;  ///< 1..100,000,000
  int seed = 1;
};

/// Compares the impact model with the oracle: over random and hostile scenes, and over the quiet
/// speeds of every case. Its result `failed` is true if a count called certain is wrong. Throws
/// InputError for a number of scenes out of range.
Study verification_study(const VerificationOptions& options);

/// What comparisons with the oracle come to, as a row: scenes, a name; number; capped, where the
/// oracle stopped; certain, the share of the others; wrong_certain and wrong_uncertain, counts that
/// are wrong. Of the fast impacts of scenes called certain: missed, spurious, matched; time_error
/// [s] and speed_error [m/s], the largest where all impacts match.
Table tally(const std::string& name, const std::vector<carrier_track::Comparison>& comparisons);

}  // namespace ricochet::studies
