#pragma once

#include <cstddef>
#include <vector>

namespace ricochet::studies::variants {

/// Returns the indices of the peaks of the samples, by the rules of MATLAB's findpeaks without
/// further options (MathWorks, findpeaks, Signal Processing Toolbox): a sample above both
/// neighbours is a peak; of equal samples in a row the first is used; the ends are not peaks. In
/// rising order.
std::vector<std::size_t> find_peaks(const std::vector<double>& samples);

/// The same with MinPeakDistance: from the highest peak down, the first of equals, each removes the
/// others within `distance` samples.
std::vector<std::size_t> find_peaks(const std::vector<double>& samples, double distance);

}  // namespace ricochet::studies::variants
