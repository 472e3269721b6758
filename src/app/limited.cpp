#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <stop_token>

#include "ricochet/error.h"
#include "src/app/scene_choice.h"
#include "src/core/progress.h"

namespace ricochet::cli {

namespace {

double checked(double seconds) {
  if (seconds > 0) return seconds;
  throw InputError(fmt::format("--seconds {}: must be > 0 [s]; inf: no limit", seconds));
}

/// Waits, or returns true as soon as there is nothing more to show.
bool ends_within(std::chrono::milliseconds time, const std::stop_token& end) {
  std::mutex mutex;
  std::condition_variable_any ended;
  std::unique_lock lock(mutex);
  return ended.wait_for(lock, end, time, [&] { return end.stop_requested(); });
}

void show(const std::stop_token& end, const TimeLimit& limit) {
  using namespace std::chrono_literals;
  auto begun = std::chrono::steady_clock::now();
  if (ends_within(1s, end)) return;
  const char* stage = nullptr;
  Progress progress("simulation", 1, Progress::First::at_once);
  double shown = 0;
  do {
    if (limit.stage() != stage) {
      stage = limit.stage();
      progress.begin(stage, begun);
      shown = 0;
    }
    begun = std::chrono::steady_clock::now();  // of the next stage
    const double share = limit.share();
    progress.advance(share - shown);
    shown = share;
  } while (!ends_within(100ms, end));
}

}  // namespace

void add_seconds(CLI::App* command, double& seconds) {
  add_value(command, "--seconds", seconds,
            "Time limit [s], after which it ends with what it knows, and exit code 1");
}

Limited::Limited(double seconds, double kept)
    : seconds_(checked(seconds)),
      limit_(seconds - kept),
      shown_([this](const std::stop_token& end) { show(end, limit_); }) {}

std::runtime_error Limited::reached() const {
  const std::string place =
      limit_.stage() == nullptr
          ? ""
          : fmt::format(" at {:.0f} % of: {}", 100 * limit_.share(), limit_.stage());
  return std::runtime_error(
      fmt::format("the time limit of {} s was reached{}; --seconds gives more", seconds_, place));
}

double seconds_to_sample(double seconds) {
  return std::min(5.0, seconds / 2);
}

std::vector<carrier_track::SampledTurns> sampled_in_time(const carrier_track::Scene& scene,
                                                         double from, double to, double seconds) {
  const Limited limit(seconds);
  return carrier_track::sampled_turns(scene, from, to);
}

int report_incomplete(double seconds, const std::string& what_is_known) {
  fmt::print(stderr,
             "ricochet: not complete: the time limit of {} s was reached; {}; --seconds gives "
             "more\n",
             seconds, what_is_known);
  return 1;
}

}  // namespace ricochet::cli
