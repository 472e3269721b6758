#pragma once

#include "src/studies/study.h"

namespace ricochet::studies {

struct VerificationOptions {
  int scenes = 10000;  ///< 1..100,000,000
  int seed = 1;
};

/// Sets the impact model against the oracle: over random and hostile scenes, and over the quiet
/// speeds of every case. Its results have `failed`: whether a count called certain is wrong. Throws
/// InputError for a number of scenes out of range.
Study verification_study(const VerificationOptions& options);

}  // namespace ricochet::studies
