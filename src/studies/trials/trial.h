#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/open_constants.h"
#include "problems/carrier_track/questions/misfit.h"

namespace ricochet::studies::trials {

/// A value for every constant of a trial.
struct TrialConstants {
  carrier_track::Constants base;  ///< those of the reading that it changes
  std::vector<double> own;        ///< one a constant of its own
};

/// How far a simulation goes.
struct Patience {
  int most = std::numeric_limits<int>::max();  ///< counts beyond are taken for one more than this
  /// Of the slowest impact that counts: a body that rebounds slower may rest. 0: resting_speed_of.
  double resting_share = 0;
};

/// Of a search, as misfit.h has it.
inline constexpr Patience searching = {carrier_track::most_counted, 0.01};
/// Of a judgement.
inline constexpr Patience judging = {};

/// A reading of the paper that is none of paper/reading.h: one of those, its base, of which
/// something is changed that no Reading and no Scene can say.
struct Trial {
  std::string name;                              ///< e.g. "press-of-y"
  std::string description;                       ///< a sentence
  carrier_track::Reading base;                   ///
  std::vector<carrier_track::Open> freed;        ///< constants of the base that a search may move
  std::vector<carrier_track::OpenConstant> own;  ///< and those that the trial adds; natural: where
                                                 ///< a search begins
  /// Whether it is integrated step by step, at a hundred times the price of a simulation, or what
  /// such a one is measured by: searched with few evaluations.
  bool brief = false;

  /// The counts of a case at any speed, by the constants, which are copied.
  std::function<carrier_track::CountAt(const carrier_track::Case&, const TrialConstants&,
                                       const Patience&)>
      counts = {};
};

/// Where a search begins: the natural values, from which nobody has searched yet; a brief one
/// begins at the constants of the default reading.
TrialConstants start_of(const Trial& trial);

/// The misfit (misfit.h) of a trial.
double misfit_of(const Trial& trial, const TrialConstants& constants);

}  // namespace ricochet::studies::trials
