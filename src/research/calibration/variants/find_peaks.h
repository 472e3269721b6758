#pragma once

#include <cstddef>
#include <vector>

namespace ricochet::studies::trials {

/// Where the samples have their peaks, by the rules of MATLAB's findpeaks without further options
/// (MathWorks, findpeaks, Signal Processing Toolbox): a sample above both neighbours is a peak; of
/// equal samples in a row the first stands for all; the ends are none. In rising order.
std::vector<std::size_t> find_peaks(const std::vector<double>& samples);

/// The same with MinPeakDistance: from the highest peak down, the first of equals, each removes the
/// others that are no further away than `distance` samples.
std::vector<std::size_t> find_peaks(const std::vector<double>& samples, double distance);

}  // namespace ricochet::studies::trials
