#include "problems/carrier_track/models/extrapolation.h"

namespace ricochet::carrier_track::inline models {

Extrapolated extrapolated(const ExtrapolationRule& rule, std::size_t rows,
                          ExtrapolationTable table) {
  for (std::size_t j = 1; j < rows; ++j) {
    ExtrapolationState best = table[j];
    for (std::size_t m = 0; m < j; ++m) {
      const double weight = rule.weight[j][j - m - 1];
      for (std::size_t i = 0; i < 3; ++i) {
        const double next = best[i] + (best[i] - table[m][i]) * weight;
        table[m][i] = best[i];
        best[i] = next;
      }
    }
    table[j] = best;
  }
  Extrapolated result{table[rows - 1], {}};
  for (std::size_t i = 0; i < 3; ++i) result.error[i] = result.change[i] - table[rows - 2][i];
  return result;
}

}  // namespace ricochet::carrier_track::inline models
