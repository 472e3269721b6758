#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "problems/carrier_track/problems/best_known.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"

namespace ricochet::studies::best_values {

using carrier_track::BestKnown;
using carrier_track::BestValues;

/// The values in a file; none if there is no file. Throws InputError for invalid text.
BestValues read_if_there(const std::filesystem::path& file);

/// The true objective of a value's point, evaluated by this version; infinite if it is not a
/// feasible point of the problem.
double worth(const Problem& problem, const BestKnown& best);

/// The provenance of the last point of a run's trace, which must not be empty.
std::string finder_of(const RunRecord& record);

/// The best values of the problems, by name: those in the program or in the file, whichever is
/// better, the file's if they are equal; evaluated by this version.
BestValues known_values(const std::vector<Problem>& problems, const std::filesystem::path& file);

}  // namespace ricochet::studies::best_values
