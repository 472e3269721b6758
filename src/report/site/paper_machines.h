#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/chart.h"
#include "src/report/site/entries.h"

namespace ricochet::site {

/// One of the paper's machines, with its thresholds in the long run.
struct PaperMachine {
  std::string id;
  double restitution, friction, disturbance;
  std::optional<double> silent_up_to, quiet_up_to;  ///< [rad/s]
  std::optional<double> paper_threshold;            ///< [rad/s]; C11 and C12 have none
};

/// How far a constant moves the threshold, with the others held.
struct ThresholdEffect {
  std::string constant;
  double from, to;     ///< of the constant, at its ends
  double least, most;  ///< threshold at `to` over that at `from`, over the pairs
  std::size_t pairs;
};

/// The paper's machines, fastest first, as a report of the paper's cases computed them.
struct PaperMachines {
  std::string folder;  ///< of the report
  std::vector<PaperMachine> machines;
  double error;                        ///< root mean square in log speed, by the paper's rule
  std::int64_t compared;               ///< thresholds
  std::optional<std::int64_t> fitted;  ///< parameters fitted to these thresholds
};

/// Reads them from the first report of the paper's cases. Nothing if there is none. Throws
/// Json::exception if its data are of another version.
std::optional<PaperMachines> paper_machines(const std::vector<FoundReport>& reports);

/// Effects of restitution, friction and disturbance, from pairs of machines that differ in one
/// constant alone: in its smallest and its largest value.
std::vector<ThresholdEffect> threshold_effects(const std::vector<PaperMachine>& machines);

/// Smallest and largest quiet threshold [rad/s]; nothing if no machine has one.
std::optional<std::pair<double, double>> quiet_range(const std::vector<PaperMachine>& machines);

/// Shows each machine as a column: silent, quiet and loud speeds, and the paper's threshold.
report::Chart regimes_chart(const PaperMachines& machines);

/// The answers, in sentences.
std::string speed_sentence(const PaperMachines& machines);
std::string effects_sentence(const PaperMachines& machines);
/// Which machines have which restitution and friction.
std::string groups_sentence(const PaperMachines& machines);
std::string agreement_sentence(const PaperMachines& machines);

}  // namespace ricochet::site
