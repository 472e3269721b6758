#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "src/report/json.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"
#include "tests/carrier_track/regimes/long_simulation.h"

/// Whether commands answer in time, and rightly, about the strange machines FIRST to LAST:
///
///   ricochet_answers_check PROGRAM FIRST LAST SECONDS [COMMAND...]
///
/// Each COMMAND, of threshold, regimes, advise and identify, is called as users do, with this time
/// limit. identify gets knocks that are simulated for a machine like the strange one, and a file
/// that is wrong by up to 30 %. What threshold and regimes call certain is compared with long
/// simulations at a random speed of each regime and just inside its borders: under a disturbance of
/// 150 phases; from the machine's start, or, where that leads to another of several motions, from
/// the one that it is on if its speed rises slowly. Prints a line for each call that is late by
/// more than a second, silent, ended in another way than with exit code 0, 1 or 2, or wrong; a call
/// that is late is repeated once; then for each command how many calls answered, and the longest.
/// Exit code: 1 if there is such a line.
namespace ricochet::carrier_track {
namespace {

namespace fs = std::filesystem;
using report::Json;

constexpr double late = 1;                // [s], after the limit
constexpr double silent = 2;              // [s], without a line on standard error
constexpr double slowest = 0.01;          // [rad/s]
constexpr double fastest = 18;            // [rad/s]
constexpr double to_compare = 4;          // [s], for the simulations at one speed
constexpr std::size_t most_regimes = 12;  // that are compared, of one machine

/// How a call went.
struct Call {
  int code = -1;  ///< exit code; -1: ended by a signal
  double seconds = 0;
  double processor = 0;  ///< [s], of all its threads
  double megabytes = 0;
  std::string output, messages;
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Call called(const std::vector<std::string>& arguments, const fs::path& folder) {
  const fs::path output = folder / "output", messages = folder / "messages";
  std::vector<char*> pointers;
  for (const std::string& each : arguments) pointers.push_back(const_cast<char*>(each.c_str()));
  pointers.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    const auto write_to = [](const fs::path& file, int descriptor) {
      dup2(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), descriptor);
    };
    write_to(output, STDOUT_FILENO);
    write_to(messages, STDERR_FILENO);
    execv(pointers[0], pointers.data());
    _exit(126);
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - start;
  const auto seconds_of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          lasted.count(),
          seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
          static_cast<double>(used.ru_maxrss) / 1024,
          text_of(output),
          text_of(messages)};
}

struct Range {
  double least, most;
};

/// The fewest and the most collisions in a turn of a disturbed machine, after so many turns.
Range counted_at_phases(Scene scene, double omega, int settling) {
  constexpr int phases = 150;
  constexpr int observed = 8;
  scene = at_speed(scene, omega);
  scene.fidelity = Fidelity::impact;
  begin_turns_at_rest(scene);
  std::vector<double> even;
  for (int k = 0; k < phases; ++k)
    even.push_back(scene.disturbance_phase + 2 * std::numbers::pi * k / phases);
  Range range{1e300, -1};
  for (const ObservedTurn& turn : observed_turns(scene, even, settling, observed)) {
    range = {std::min<double>(range.least, turn.collisions),
             std::max<double>(range.most, turn.collisions)};
  }
  return range;
}

/// A regime as a command printed it.
struct PrintedRegime {
  double from, to, least, most, memory;
  int turns;
  bool certain;
  std::string ends_by;
};

std::vector<PrintedRegime> regimes_in(const Json& rows) {
  std::vector<PrintedRegime> all;
  for (const Json& row : rows) {
    all.push_back({row["from"], row["to"], row["least_per_turn"], row["most_per_turn"],
                   row["memory"].is_null() ? 0 : row["memory"].get<double>(), row["turns"],
                   row["certain"], row["ends_by"]});
  }
  return all;
}

/// The counts of a machine whose motions repeat: from its own start, and, if these are not as
/// printed, since several motions may be possible, on the motion that it is on if its speed rises
/// slowly.
class UndisturbedCounts {
 public:
  UndisturbedCounts(const Scene& scene, const PrintedRegime& regime)
      : scene_(scene), regime_(regime) {
    scene_.fidelity = Fidelity::impact;
  }

  bool agree(double omega, double& counted) {
    const int periods = regime_.turns * std::max(1, 40 / regime_.turns);
    for (const int settling : {100, 2000}) {
      counted = collisions_in_the_long_run(scene_, omega, settling + periods, periods);
      if (is_printed(counted)) return true;
    }
    const std::vector<Regime> all = regimes_of(scene_, {slowest, omega * (1 + 1e-9)});
    if (all.back().ends_by == RegimeEnd::time_limit) throw TimeLimitReached();
    const Regime& here = regime_at(all, std::min(omega, all.back().to));
    // Next to a wall even a small step of the speed may lead to another motion.
    for (const Scene& start : {brought(here.first.orbit, omega), here.last.orbit}) {
      counted = collisions_in_the_long_run(start, omega, 300 + periods, periods);
      if (is_printed(counted)) return true;
    }
    return false;
  }

 private:
  bool is_printed(double counted) const {
    return std::abs(counted - regime_.most) < 1e-9 * (1 + counted);
  }

  Scene scene_;
  const PrintedRegime& regime_;
};

class Check {
 public:
  Check(std::string program, double seconds, fs::path folder)
      : program_(std::move(program)), seconds_(seconds), folder_(std::move(folder)) {}

  void machine(std::uint64_t seed, const std::vector<std::string>& commands) {
    seed_ = seed;
    scene_ = strange_machine(seed);
    check(scene_, fmt::format("machine {}", seed));
    file_ = folder_ / fmt::format("machine-{}.toml", seed);
    std::ofstream(file_) << write_scene(scene_);
    first_loud_.reset();
    for (const std::string& command : commands) {
      if (command == "threshold") threshold();
      if (command == "regimes") regimes();
      if (command == "advise") advise();
      if (command == "identify") identify();
    }
  }

  /// Returns the number of lines that were printed about single calls.
  int print() const {
    for (const auto& [command, tally] : tallies_) {
      fmt::print(
          "{}: {} answered, {} at the limit or not certain, {} refused, {} otherwise; longest "
          "{:.2f} s (machine {}), most memory {:.0f} MB (machine {}); {} late, {} silent\n",
          command, tally.codes[0], tally.codes[1], tally.codes[2], tally.codes[3], tally.longest,
          tally.longest_of, tally.megabytes, tally.megabytes_of, tally.late, tally.silent);
    }
    fmt::print("{} speeds compared, {} without a result in time, {} wrong; {} other faults\n",
               compared_, undecided_, wrong_, faults_);
    return wrong_ + faults_;
  }

 private:
  struct Tally {
    int codes[4] = {};
    double longest = 0, megabytes = 0;
    std::uint64_t longest_of = 0, megabytes_of = 0;
    int late = 0, silent = 0;
  };

  template <class... Values>
  void fault(const char* command, fmt::format_string<const Values&...> what,
             const Values&... values) {
    ++faults_;
    fmt::print("machine {}: {}: {}\n", seed_, command, fmt::format(what, values...));
  }

  Call call(const char* command, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program_);
    arguments.insert(arguments.end(), {"--seconds", fmt::format("{}", seconds_)});
    Call result = called(arguments, folder_);
    // Another program may have had the processors meanwhile.
    if (result.seconds > seconds_ + late) result = called(arguments, folder_);
    Tally& tally = tallies_[command];
    const bool usual = result.code >= 0 && result.code <= 2;
    ++tally.codes[usual ? result.code : 3];
    if (result.seconds > tally.longest) {
      tally.longest = result.seconds;
      tally.longest_of = seed_;
    }
    if (result.megabytes > tally.megabytes) {
      tally.megabytes = result.megabytes;
      tally.megabytes_of = seed_;
    }
    if (!usual) fault(command, "exit code {}: {}", result.code, result.messages);
    if (result.seconds > seconds_ + late) {
      ++tally.late;
      fault(command, "late: {:.2f} s, {:.2f} s of processors", result.seconds, result.processor);
    }
    if (result.seconds > silent && result.messages.empty()) {
      ++tally.silent;
      fault(command, "silent for {:.2f} s", result.seconds);
    }
    const auto says = [](const std::string& text, const char* what) {
      return text.find(what) != std::string::npos;
    };
    // A fit from a file that is wrong by so much may fail, and says so.
    if (result.code == 1 && !says(result.messages, "--seconds") &&
        !says(result.output, "The record contradicts") &&
        !says(result.output, "has not converged")) {
      fault(command, "failed: {}", result.messages);
    }
    if (result.code == 2 && has_regimes(scene_)) fault(command, "refused: {}", result.messages);
    return result;
  }

  void threshold() {
    const Call result =
        call("threshold", {"threshold", "--format", "json", "--scene", file_.string()});
    if (result.output.empty() || result.code > 1) return;
    const Json answer = Json::parse(result.output);
    const bool complete = answer["complete"];
    if (complete != (result.code == 0)) fault("threshold", "exit code {}", result.code);
    const Json& quiet = answer["fastest_quiet"];
    if (quiet.is_null() && answer["reason"].is_null()) fault("threshold", "no reason");
    if (!has_regimes(scene_)) return;
    if (quiet.is_number() && !(quiet >= slowest && quiet <= fastest)) {
      fault("threshold", "quiet up to {} rad/s", quiet.get<double>());
    }
    const std::vector<PrintedRegime> all = regimes_in(answer["regimes"]);
    compare("threshold", all);
    const auto louder = std::find_if(all.begin(), all.end(), [](const PrintedRegime& each) {
      return each.most > quiet_per_turn;
    });
    const Json& loud = answer["first_loud"];
    if (loud.is_number() != (louder != all.end()) ||
        (loud.is_number() && std::abs(loud.get<double>() / louder->from - 1) > 1e-6)) {
      fault("threshold", "first loud {}, but not by its regimes", loud.dump());
    }
    if (quiet.is_number() && loud.is_number() &&
        !(quiet < loud && quiet.get<double>() > loud.get<double>() - 0.0011)) {
      fault("threshold", "quiet up to {}, loud from {}", quiet.dump(), loud.dump());
    }
    if (complete) first_loud_ = loud.is_number() ? loud.get<double>() : fastest;
  }

  void regimes() {
    if (!has_regimes(scene_)) return;
    const Call result = call("regimes", {"regimes", "--format", "json", "--scene", file_.string()});
    if (result.output.empty() || result.code > 1) return;
    const std::vector<PrintedRegime> all = regimes_in(Json::parse(result.output));
    const bool complete =
        !all.empty() && all.back().to == fastest && all.back().ends_by != "time-limit";
    if (complete != (result.code == 0)) fault("regimes", "exit code {}", result.code);
    if (!first_loud_) compare("regimes", all);
  }

  void advise() {
    const fs::path page = folder_ / "page";
    const Call result =
        call("advise", {"machine", "advise", file_.string(), "--out", page.string()});
    if (result.code == 0 && first_loud_) {
      const Json data = Json::parse(text_of(page / "data.json"))["values"];
      const Json& quiet = data["fastest-quiet"];
      if (quiet.is_number() && std::abs(quiet.get<double>() - *first_loud_) > 0.0011) {
        fault("advise", "quiet up to {}, but threshold {}", quiet.dump(), *first_loud_);
      }
    }
    fs::remove_all(page);
  }

  /// A record of a machine like this one, and a file with a guess.
  void identify() {
    MachineDraw draw(seed_ + 9'000'000);
    Scene truth = scene_;
    truth.fidelity = Fidelity::impact;
    truth.rule = CountRule::impacts;
    truth.disturbance = 0;
    truth.centrifugal = Centrifugal::projected;
    truth.restitution_upper = truth.restitution_lower;
    if (!std::isfinite(truth.wall_upper)) truth.wall_upper = truth.start_position + 1e-3;
    if (truth.friction == 0) truth.friction = 0.1;
    truth.friction = std::min(truth.friction, 0.9);
    if (truth.centrifugal_mass_radius == 0) truth.centrifugal_mass_radius = 0.1;
    const double first = draw.even(1, 5);
    const std::vector<SpeedKnot<double>> speed = {{0, first}, {60, draw.even(first, 18)}};
    SensorModel sensor;
    sensor.detection_limit = std::max(truth.counting_limit, 1e-3);
    sensor.strengths = draw.in(0.5);
    if (draw.in(0.5)) sensor.mark_jitter = 1e-3;
    Random random(seed_);
    KnockRecord record;
    try {
      const TimeLimit limit(to_compare);
      record = synthetic_knocks(truth, speed, sensor, random);
    } catch (const std::exception&) {
      return;  // too many impacts
    }
    const fs::path knocks = folder_ / fmt::format("knocks-{}.csv", seed_);
    const fs::path speeds = folder_ / fmt::format("speed-{}.csv", seed_);
    const fs::path guess = folder_ / fmt::format("guess-{}.toml", seed_);
    std::ofstream rows(knocks);
    rows << (sensor.strengths ? "time,strength\n" : "time\n");
    for (const Knock& knock : record.knocks) {
      rows << fmt::format("{:.6f}", knock.time);
      if (knock.strength) rows << fmt::format(",{:.6g}", *knock.strength);
      rows << "\n";
    }
    rows.close();
    std::ofstream(speeds) << fmt::format("time,omega\n0,{}\n60,{}\n", speed[0].omega,
                                         speed[1].omega);
    truth.restitution_lower = std::min(1.0, truth.restitution_lower * draw.even(0.7, 1.3));
    truth.restitution_upper = truth.restitution_lower;
    truth.friction *= draw.even(0.8, 1.2);
    truth.wall_upper *= draw.even(0.7, 1.3);
    truth.start_position = std::min(truth.start_position, truth.wall_upper);
    std::ofstream(guess) << write_scene(truth);
    std::vector<std::string> arguments = {"identify", knocks.string(), "--scene",  guess.string(),
                                          "--speed",  speeds.string(), "--format", "json"};
    if (record.plate) {
      const fs::path marks = folder_ / fmt::format("marks-{}.csv", seed_);
      std::ofstream times(marks);
      times << "time\n";
      for (const double time : mark_times(scene_, record, *sensor.mark_jitter, random)) {
        times << fmt::format("{:.6f}\n", time);
      }
      arguments.insert(arguments.end(), {"--marks", marks.string()});
    }
    identified(arguments);
  }

  void identified(const std::vector<std::string>& arguments) {
    const bool had_regimes = has_regimes(scene_);
    scene_.rule = CountRule::peaks;  // a record may be refused: it may have no knocks
    const Call result = call("identify", arguments);
    scene_ = had_regimes ? strange_machine(seed_) : scene_;
    if (result.output.empty() || result.code > 1) return;
    const Json answer = Json::parse(result.output);
    const bool trusted = answer["complete"] && answer["contradictions"].empty();
    if (result.code == 0 && !trusted) fault("identify", "exit code {}", result.code);
  }

  /// Compares certain regimes with simulations at a random speed and just inside their borders.
  void compare(const char* command, const std::vector<PrintedRegime>& all) {
    MachineDraw draw(seed_ + 8'000'000);
    std::size_t every = (all.size() + most_regimes - 1) / most_regimes;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const PrintedRegime& regime = all[i];
      const double inside = 1e-5;
      const double random = draw.even_logarithm(regime.from, regime.to);
      const bool chosen = i % every == 0 || regime.most <= quiet_per_turn;
      if (!regime.certain || !chosen || regime.to < regime.from * (1 + 3 * inside)) continue;
      for (const double omega : {regime.from * (1 + inside), random, regime.to * (1 - inside)}) {
        try {
          const TimeLimit limit(to_compare);
          compare_at(command, regime, omega);
          ++compared_;
        } catch (const TimeLimitReached&) {
          ++undecided_;
        } catch (const std::runtime_error&) {
          ++undecided_;  // too many impacts
        }
      }
    }
  }

  void compare_at(const char* command, const PrintedRegime& regime, double omega) {
    const auto wrong = [&](double least, double most) {
      ++wrong_;
      fmt::print(
          "machine {}: {}: at {:.9g} rad/s {:.6g} to {:.6g} collisions a turn, said {} to "
          "{}\n",
          seed_, command, omega, least, most, regime.least, regime.most);
    };
    if (is_disturbed(scene_)) {
      Range range{};
      for (const int settling : {20, 300, 3000}) {  // elastic carriers settle slowly
        range = counted_at_phases(scene_, omega, settling);
        if (range.least >= regime.least && range.most <= regime.most) return;
      }
      // Several motions may be possible: on the wall where it rests if its speed rises slowly.
      const std::vector<Regime> known = regimes_of(scene_, {slowest, omega * (1 + 1e-9)});
      Scene rising = scene_;
      rising.start_position = known.back().last.orbit.start_position;
      rising.start_velocity = 0;
      const Range from_rest = counted_at_phases(rising, omega, 300);
      if (from_rest.least >= regime.least && from_rest.most <= regime.most) return;
      return wrong(range.least, range.most);
    }
    double counted = 0;
    if (!UndisturbedCounts(scene_, regime).agree(omega, counted)) wrong(counted, counted);
  }

  std::string program_;
  double seconds_;
  fs::path folder_;
  std::uint64_t seed_ = 0;
  Scene scene_;
  fs::path file_;
  std::optional<double> first_loud_;  ///< [rad/s], as a complete threshold says
  std::map<std::string, Tally> tallies_;
  int compared_ = 0, undecided_ = 0, wrong_ = 0, faults_ = 0;
};

int run(const std::vector<std::string>& arguments) {
  std::vector<std::string> commands(arguments.begin() + 4, arguments.end());
  if (commands.empty()) commands = {"threshold", "regimes", "advise", "identify"};
  std::string name = (fs::temp_directory_path() / "ricochet-answers-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
  Check check(arguments.at(0), std::stod(arguments.at(3)), name);
  const auto last = static_cast<std::uint64_t>(std::stoll(arguments.at(2)));
  for (auto seed = static_cast<std::uint64_t>(std::stoll(arguments.at(1))); seed <= last; ++seed) {
    check.machine(seed, commands);
    std::fflush(stdout);
  }
  fmt::print("{} holds the files\n", name);
  return check.print() == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ricochet::carrier_track

int main(int argc, char** argv) {
  return ricochet::carrier_track::run({argv + 1, argv + argc});
}
