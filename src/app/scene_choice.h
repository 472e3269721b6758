#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "src/app/command_line.h"

namespace ricochet::cli {

/// The scene that the user selected: one of the paper's cases, or a machine of the user.
struct SceneChoice {
  std::string case_id;                     ///< of --case, empty if not given
  std::string scene_file;                  ///< of --scene, empty if not given
  std::vector<std::string> settings = {};  ///< of --set, each KEY=VALUE
};

struct ChosenScene {
  std::string name;  ///< the case's id, or the file's stem; with the settings
  std::string interpretation;
  carrier_track::Scene scene;
  carrier_track::Claim claim;       ///< empty for a user's machine, as is a case with settings
  carrier_track::SceneFile source;  ///< says how uncertain the scene's numbers are
};

/// Adds --case, --scene and --set.
void add_scene_choice(CLI::App* command, SceneChoice& choice);

/// Adds the machine file that a command takes, and --set.
void add_machine_file(CLI::App* command, SceneChoice& choice);

/// Throws InputError for an unknown case, an invalid file or setting, or unless exactly one of case
/// and file is given.
ChosenScene choose_scene(const SceneChoice& choice);

/// Every case of the paper, in the default interpretation.
std::vector<ChosenScene> every_case();

/// The user's options for a machine's quiet speed.
struct QuietSpeedRequest {
  double fastest = 18.0;                 ///< [rad/s], end of the range searched
  std::optional<double> allow;           ///< collisions in the window
  std::optional<double> allow_per_turn;  ///< collisions
  std::optional<double> allow_energy;    ///< [J], in the window
  std::optional<double> allow_speed;     ///< [m/s], of the fastest impact
  double tolerance = 0;                  ///< [%], of every model parameter
  double seconds = 60;                   ///< time limit
};

/// Adds the options of a request.
void add_request(CLI::App* command, QuietSpeedRequest& asked);

/// Throws InputError if a value is out of range, or if more than one limit is given.
carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request);

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
