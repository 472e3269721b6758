#pragma once

#include <string>
#include <thread>
#include <vector>

#include "problems/carrier_track/regimes/sampled_turns.h"
#include "ricochet/evaluator.h"
#include "src/app/command_line.h"

namespace ricochet::cli {

/// Adds --seconds, the time after which a command ends with what it knows.
void add_seconds(CLI::App* command, double& seconds);

/// A time limit, and its progress on standard error from the first second on.
class Limited {
 public:
  /// Throws InputError unless 0 < seconds. `kept`: of these, for what is done afterwards.
  explicit Limited(double seconds, double kept = 0);

  /// That nothing is known yet, and how far the work was: exit code 1.
  std::runtime_error reached() const;

 private:
  double seconds_;
  TimeLimit limit_;
  std::jthread shown_;
};

/// Returns what `work` returns, under a limit, see Limited. Throws a std::runtime_error if that
/// throws TimeLimitReached.
template <class Work>
auto limited(double seconds, const Work& work, double kept = 0) {
  const Limited limit(seconds, kept);
  try {
    return work();
  } catch (const TimeLimitReached&) {
    throw limit.reached();
  }
}

/// The seconds of a time limit that are kept for sampled_in_time().
double seconds_to_sample(double seconds);

/// What simulation alone tells in these seconds of the speeds of a machine that the time limit left
/// out.
std::vector<carrier_track::SampledTurns> sampled_in_time(const carrier_track::Scene& scene,
                                                         double from, double to, double seconds);

/// Says on standard error that a result is not complete, and why. Returns the exit code.
int report_incomplete(double seconds, const std::string& what_is_known);

}  // namespace ricochet::cli
