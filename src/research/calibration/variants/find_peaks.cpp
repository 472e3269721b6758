#include "src/research/calibration/variants/find_peaks.h"

#include <algorithm>
#include <numeric>

namespace ricochet::studies::variants {

std::vector<std::size_t> find_peaks(const std::vector<double>& samples) {
  std::vector<std::size_t> peaks;
  bool rising = false;
  std::size_t first = 0;  // of the equal samples
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (samples[k] == samples[first]) continue;
    const bool falls = samples[k] < samples[first];
    if (rising && falls) peaks.push_back(first);
    rising = !falls;
    first = k;
  }
  return peaks;
}

std::vector<std::size_t> find_peaks(const std::vector<double>& samples, double distance) {
  std::vector<std::size_t> peaks = find_peaks(samples);
  if (!(distance >= 1)) return peaks;
  std::vector<std::size_t> order(peaks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return samples[peaks[a]] > samples[peaks[b]];
  });
  std::vector<bool> removed(peaks.size());
  const auto near = [&](std::size_t a, std::size_t b) {
    const std::size_t apart = peaks[a] > peaks[b] ? peaks[a] - peaks[b] : peaks[b] - peaks[a];
    return static_cast<double>(apart) <= distance;
  };
  for (const std::size_t highest : order) {
    if (removed[highest]) continue;
    for (std::size_t k = highest; k-- > 0 && near(k, highest);) removed[k] = true;
    for (std::size_t k = highest + 1; k < peaks.size() && near(k, highest); ++k) removed[k] = true;
  }
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    if (!removed[k]) kept.push_back(peaks[k]);
  }
  return kept;
}

}  // namespace ricochet::studies::variants
