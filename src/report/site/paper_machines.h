#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/chart.h"
#include "src/report/site/entries.h"

namespace ricochet::site {

/// Where the report of the paper's cases has a row for each.
inline constexpr const char* cases_anchor = "#thresholds-of-every-case";

inline constexpr double rpm = 30 / std::numbers::pi;  // of 1 rad/s

/// One of the paper's machines, with its thresholds in the long run.
struct PaperMachine {
  std::string id;
  double restitution, friction, disturbance;
  std::optional<double> silent_up_to, quiet_up_to;  ///< [rad/s]
  std::optional<double> paper_threshold;            ///< [rad/s]; C11 and C12 have none
};

/// The paper's machines, fastest first, as a report of the paper's cases computed them.
struct PaperMachines {
  std::string folder;  ///< of the report
  std::vector<PaperMachine> machines;
  double error;                        ///< root mean square in log speed, by the paper's rule
  std::int64_t compared;               ///< thresholds
  std::optional<std::int64_t> fitted;  ///< parameters fitted to these thresholds
  std::string moves;                   ///< what moves the thresholds, in sentences; may be empty
  std::vector<report::Chart> charts;   ///< the thresholds over the constants that move them
};

/// Reads them from the first report of the paper's cases. Nothing if there is none. Throws
/// Json::exception or std::logic_error if its data are of another version.
std::optional<PaperMachines> paper_machines(const std::vector<FoundReport>& reports);

/// Smallest and largest quiet threshold [rad/s]; nothing if no machine has one.
std::optional<std::pair<double, double>> quiet_range(const std::vector<PaperMachine>& machines);

/// Shows each machine as a column: silent, quiet and loud speeds, and the paper's threshold.
report::Chart regimes_chart(const PaperMachines& machines);

/// The answers, in sentences.
std::string speed_sentence(const PaperMachines& machines);
/// What moves the thresholds, as the report has it; may be empty.
std::string effects_sentence(const PaperMachines& machines);
/// Which machines have which restitution and friction.
std::string groups_sentence(const PaperMachines& machines);
std::string agreement_sentence(const PaperMachines& machines);

}  // namespace ricochet::site
