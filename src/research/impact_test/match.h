#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ricochet/recording.h"

namespace ricochet::studies::impact_test {

/// For each true impact the place of its partner in the other list, or nothing. Both lists are in
/// order of time. Partners are on the same wall and at most `apart` [s] away from each other; on a
/// wall they keep their order, and nobody has two. Of all such pairings this one has the most
/// pairs, and of those the smallest sum of differences in time.
std::vector<std::optional<std::size_t>> partners_of(
    const std::vector<carrier_track::Impact>& true_ones,
    const std::vector<carrier_track::Impact>& found, double apart);

}  // namespace ricochet::studies::impact_test
