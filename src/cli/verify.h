#pragma once

#include <string>

#include "problems/carrier_track/check/verification/study.h"

namespace ricochet::cli {

/// Prints a scene of `verify` as TOML or JSON, with the impacts of the library and of the oracle,
/// to examine a disagreement. Throws InputError for a negative index.
void show_hostile_scene(int seed, int index, bool json);

/// Runs the study, writes its report into the folder, and prints its summary, or its results as
/// JSON. Returns the exit code: 1 where a count called certain is wrong.
int verify(const studies::VerificationOptions& options, const std::string& folder, bool json);

}  // namespace ricochet::cli
