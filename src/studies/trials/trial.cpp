#include "src/studies/trials/trial.h"

#include "problems/carrier_track/paper/fitted_reading.h"

namespace ricochet::studies::trials {

using namespace carrier_track;

TrialConstants start_of(const Trial& trial) {
  TrialConstants constants{trial.brief ? default_reading().constants : natural_constants(), {}};
  for (const OpenConstant& own : trial.own) constants.own.push_back(own.natural.value());
  return constants;
}

double misfit_of(const Trial& trial, const TrialConstants& constants) {
  return misfit([&](const Case& a_case, const std::vector<double>& speeds) {
    const CountAt count = trial.counts(a_case, constants, searching);
    std::vector<int> counts;
    for (const double omega : speeds) counts.push_back(count(omega));
    return counts;
  });
}

}  // namespace ricochet::studies::trials
