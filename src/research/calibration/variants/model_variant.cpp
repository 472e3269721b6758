#include "src/research/calibration/variants/model_variant.h"

#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::variants {

using namespace carrier_track;

VariantConstants start_of(const ModelVariant& variant) {
  VariantConstants constants{
      variant.brief ? default_interpretation().constants : natural_constants(), {}};
  if (variant.start) constants.base = *variant.start;
  for (const UnknownParameter& own : variant.own) constants.own.push_back(own.natural.value());
  return constants;
}

double loss_of(const ModelVariant& variant, const VariantConstants& constants) {
  return loss([&](const Case& a_case, const std::vector<double>& speeds) {
    const CountAt count = variant.counts(a_case, constants, searching);
    std::vector<int> counts;
    for (const double omega : speeds) counts.push_back(count(omega));
    return counts;
  });
}

}  // namespace ricochet::studies::variants
