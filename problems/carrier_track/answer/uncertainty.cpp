#include "problems/carrier_track/answer/uncertainty.h"

#include <algorithm>
#include <cmath>

#include "ricochet/random.h"
#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline answer {

std::optional<UncertainDivide> uncertain_divide(const SceneFile& file, const Limit& limit,
                                                double omega, int machines, std::uint64_t seed) {
  const std::size_t numbers = file.uncertainties.size();
  if (numbers == 0) return std::nullopt;
  check_near(file.scene, omega, machines);
  Random random(seed);
  std::vector<Scene> drawn;
  std::vector<double> shares(numbers);
  for (int i = 0; i < machines; ++i) {
    for (double& share : shares) share = 2 * uniform(random) - 1;
    drawn.push_back(file.at(shares));
  }
  const std::optional<ToleranceRange> range = divide_range(drawn, limit, omega);
  if (!range) return std::nullopt;
  std::vector<std::optional<double>> divides(2 * numbers);
  in_parallel("uncertainties", divides.size(), [&](std::size_t i) {
    std::vector<double> one(numbers, 0);
    one[i / 2] = i % 2 == 0 ? -1 : 1;
    divides[i] = divide_near(file.at(one), limit, omega);
  });
  UncertainDivide result{{}, 0, *range};
  for (std::size_t k = 0; k < numbers; ++k) {
    const auto& below = divides[2 * k];
    const auto& above = divides[2 * k + 1];
    if (!below || !above) continue;
    const double change = (*above - *below) / 2;
    result.effects.push_back({file.uncertainties[k].key, change});
    result.first_order += std::abs(change);
  }
  std::stable_sort(result.effects.begin(), result.effects.end(), [](const auto& a, const auto& b) {
    return std::abs(a.change) > std::abs(b.change);
  });
  return result;
}

}  // namespace ricochet::carrier_track::inline answer
