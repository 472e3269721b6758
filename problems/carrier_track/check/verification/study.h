#pragma once

#include "src/report/site/study.h"

namespace ricochet::studies {

struct VerificationOptions {
  int scenes = 10000;  ///< 1..100,000,000
  int seed = 1;
};

/// Compares the impact model with the oracle: over random and hostile scenes, and over the quiet
/// speeds of every case. Its result `failed` is true if a count called certain is wrong. Throws
/// InputError for a number of scenes out of range.
Study verification_study(const VerificationOptions& options);

}  // namespace ricochet::studies
