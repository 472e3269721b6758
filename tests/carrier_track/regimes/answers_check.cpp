#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "problems/carrier_track/identification/knock_record.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "src/core/files.h"
#include "src/report/json.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"
#include "tests/carrier_track/regimes/machines.h"

/// Whether commands answer in time, and rightly, about the strange machines FIRST to LAST:
///
///   ricochet_answers_check PROGRAM FIRST LAST SECONDS [COMMAND...]
///
/// Each COMMAND, of threshold, regimes, advise and identify, is called as users do, with this time
/// limit. identify gets knocks that are simulated for a machine like the strange one, and a file
/// that is wrong by up to 30 %. Regimes that are called certain are compared with long simulations.
/// Prints a line for each call that is late by more than a second (twice), silent, ended in another
/// way than with exit code 0, 1 or 2, or wrong, and what all calls of a command have done. Exit
/// code: 1 if there is a line about a call.
namespace ricochet::carrier_track {
namespace {

namespace fs = std::filesystem;
using report::Json;

constexpr double late = 1;                      // [s], after the limit
constexpr double silent = 2;                    // [s], without a line on standard error
constexpr double slowest = 0.01, fastest = 18;  // [rad/s]
constexpr double to_compare = 4;                // [s], for the simulations at one speed
constexpr std::size_t most_regimes = 12;        // that are compared, of one machine

/// How a call went.
struct Call {
  int code = -1;  ///< exit code; -1: ended by a signal
  double seconds = 0;
  std::string output, messages;
};

Call called(const std::string& command, const fs::path& folder) {
  const fs::path output = folder / "output", messages = folder / "messages";
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system(
      fmt::format("exec {} >'{}' 2>'{}'", command, output.string(), messages.string()).c_str());
  const std::chrono::duration<double> lasted = std::chrono::steady_clock::now() - start;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, lasted.count(), text_of_file(output),
          text_of_file(messages)};
}

/// The fewest and the most collisions in a turn of a disturbed machine, after so many turns.
std::pair<double, double> counted_at_phases(const Scene& machine, double omega, int settling) {
  Scene scene = with(at_speed(machine, omega), set::fidelity(Fidelity::impact));
  begin_turns_at_rest(scene);
  std::vector<double> phases = even_phases(150);
  for (double& phase : phases) phase += scene.disturbance_phase;
  const auto turns = observed_turns(scene, phases, settling, 8);
  const auto [least, most] = std::ranges::minmax(turns, {}, &ObservedTurn::collisions);
  return {least.collisions, most.collisions};
}

/// What a machine whose motions repeat counts: as printed if it does so from its own start, or,
/// since several motions may be possible, on the motion that it is on if its speed rises slowly.
double counted_in_periods(const Scene& machine, double omega, int turns, double printed) {
  const Scene scene = with(machine, set::fidelity(Fidelity::impact));
  const int periods = turns * std::max(1, 40 / turns);
  double counted = 0;
  const auto agrees = [&](const Scene& start, int settling) {
    counted = collisions_in_the_long_run(start, omega, settling + periods, periods);
    return std::abs(counted - printed) < 1e-9 * (1 + counted);
  };
  if (agrees(scene, 100) || agrees(scene, 2000)) return printed;
  const std::vector<Regime> all = regimes_of(scene, {slowest, omega * (1 + 1e-9)});
  if (all.back().ends_by == RegimeEnd::time_limit) throw TimeLimitReached();
  const Regime& here = regime_at(all, std::min(omega, all.back().to));
  // Next to a wall even a small step of the speed may lead to another motion.
  const bool found = agrees(brought(here.first.orbit, omega), 300) || agrees(here.last.orbit, 300);
  return found ? printed : counted;
}

class Check {
 public:
  Check(std::string program, double seconds, fs::path folder)
      : program_(std::move(program)), seconds_(seconds), folder_(std::move(folder)) {}

  void machine(std::uint64_t seed, const std::vector<std::string>& commands) {
    seed_ = seed;
    scene_ = strange_machine(seed);
    check(scene_, fmt::format("machine {}", seed));
    file_ = folder_ / fmt::format("machine-{}.toml", seed);
    write_text_file(file_, write_scene(scene_));
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
          "{:.2f} s (machine {})\n",
          command, tally.codes[0], tally.codes[1], tally.codes[2], tally.codes[3],
          tally.longest.first, tally.longest.second);
    }
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    fmt::print("most memory of a call {} MB\n", used.ru_maxrss / 1024);
    fmt::print("{} speeds compared, {} without a result in time, {} wrong; {} other faults\n",
               compared_, undecided_, wrong_, faults_);
    return wrong_ + faults_;
  }

 private:
  struct Tally {
    int codes[4] = {};
    std::pair<double, std::uint64_t> longest;  // [s], and the machine
  };

  template <class... Values>
  void fault(const char* command, fmt::format_string<const Values&...> what,
             const Values&... values) {
    ++faults_;
    fmt::print("machine {}: {}: {}\n", seed_, command, fmt::format(what, values...));
  }

  Call call(const char* command, const std::string& arguments, bool may_refuse) {
    const std::string line = fmt::format("'{}' {} --seconds {}", program_, arguments, seconds_);
    Call result = called(line, folder_);
    // Another program may have had the processors meanwhile.
    if (result.seconds > seconds_ + late) result = called(line, folder_);
    Tally& tally = tallies_[command];
    const bool usual = result.code >= 0 && result.code <= 2;
    ++tally.codes[usual ? result.code : 3];
    tally.longest = std::max(tally.longest, {result.seconds, seed_});
    if (!usual) fault(command, "exit code {}: {}", result.code, result.messages);
    if (result.seconds > seconds_ + late) fault(command, "late: {:.2f} s", result.seconds);
    if (result.seconds > silent && result.messages.empty()) {
      fault(command, "silent for {:.2f} s", result.seconds);
    }
    // A fit from a file that is wrong by so much may fail, and says so.
    const bool excused = result.messages.find("--seconds") != std::string::npos ||
                         result.output.find("The record contradicts") != std::string::npos ||
                         result.output.find("has not converged") != std::string::npos;
    if (result.code == 1 && !excused) fault(command, "failed: {}", result.messages);
    if (result.code == 2 && !may_refuse) fault(command, "refused: {}", result.messages);
    return result;
  }

  /// What a call about the machine prints if `is_complete(answer)` says whether it is; null if it
  /// has no answer.
  template <class IsComplete>
  Json answer_of(const char* command, const IsComplete& is_complete) {
    const Call result =
        call(command, fmt::format("{} --format json --scene '{}'", command, file_.string()),
             !has_regimes(scene_));
    if (result.output.empty() || result.code > 1) return {};
    Json answer = Json::parse(result.output);
    if (is_complete(answer) != (result.code == 0)) fault(command, "exit code {}", result.code);
    return answer;
  }

  void threshold() {
    const Json answer =
        answer_of("threshold", [](const Json& printed) -> bool { return printed["complete"]; });
    if (answer.is_null()) return;
    const Json& quiet = answer["fastest_quiet"];
    if (quiet.is_null() && answer["reason"].is_null()) fault("threshold", "no reason");
    if (!has_regimes(scene_)) return;
    if (quiet.is_number() && !(quiet >= slowest && quiet <= fastest)) {
      fault("threshold", "quiet up to {} rad/s", quiet.get<double>());
    }
    const Json& all = answer["regimes"];
    compare("threshold", all);
    const auto louder = std::ranges::find_if(
        all, [](const Json& each) { return each["most_per_turn"] > quiet_per_turn; });
    const Json& loud = answer["first_loud"];
    const Json from = louder == all.end() ? Json() : (*louder)["from"];
    if (loud.is_number() != from.is_number() ||
        (loud.is_number() && std::abs(loud.get<double>() / from.get<double>() - 1) > 1e-6)) {
      fault("threshold", "first loud {}, but not by its regimes", loud.dump());
    }
    if (quiet.is_number() && loud.is_number() &&
        !(quiet < loud && quiet.get<double>() > loud.get<double>() - 0.0011)) {
      fault("threshold", "quiet up to {}, loud from {}", quiet.dump(), loud.dump());
    }
    if (answer["complete"]) first_loud_ = loud.is_number() ? loud.get<double>() : fastest;
  }

  void regimes() {
    if (!has_regimes(scene_)) return;
    const Json answer = answer_of("regimes", [](const Json& all) {
      return !all.empty() && all.back()["to"] == fastest && all.back()["ends_by"] != "time-limit";
    });
    if (!answer.is_null() && !first_loud_) compare("regimes", answer);
  }

  void advise() {
    const fs::path page = folder_ / "page";
    const Call result =
        call("advise", fmt::format("machine advise '{}' --out '{}'", file_.string(), page.string()),
             !has_regimes(scene_));
    if (result.code == 0 && first_loud_) {
      const Json data = Json::parse(text_of_file(page / "data.json"))["values"];
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
    Scene truth = with(scene_, set::fidelity(Fidelity::impact), set::rule(CountRule::impacts),
                       set::disturbance(0), set::centrifugal(Centrifugal::projected),
                       set::restitution(scene_.restitution_lower),
                       set::friction(scene_.friction == 0 ? 0.1 : std::min(scene_.friction, 0.9)));
    if (!std::isfinite(truth.wall_upper)) truth.wall_upper = truth.start_position + 1e-3;
    if (truth.centrifugal_mass_radius == 0) truth.centrifugal_mass_radius = 0.1;
    const double first = draw.even(1, 5), last = draw.even(first, 18);
    SensorModel sensor;
    sensor.detection_limit = std::max(truth.counting_limit, 1e-3);
    sensor.strengths = draw.in(0.5);
    if (draw.in(0.5)) sensor.mark_jitter = 1e-3;
    Random random(seed_);
    KnockRecord record;
    try {
      const TimeLimit limit(to_compare);
      record = synthetic_knocks(truth, {{0, first}, {60, last}}, sensor, random);
    } catch (const std::exception&) {
      return;  // too many impacts
    }
    std::string knocks = sensor.strengths ? "time,strength\n" : "time\n", marks = "time\n";
    for (const Knock& knock : record.knocks) {
      knocks += fmt::format("{:.6f}", knock.time);
      knocks += knock.strength ? fmt::format(",{:.6g}\n", *knock.strength) : "\n";
    }
    const Scene guess = guess_near(truth, random);
    const auto file = [&](const char* name, const std::string& text) {
      const fs::path path = folder_ / fmt::format("{}-{}", seed_, name);
      write_text_file(path, text);
      return path.string();
    };
    std::string arguments = fmt::format(
        "identify '{}' --scene '{}' --speed '{}' --format json", file("knocks.csv", knocks),
        file("guess.toml",
             write_scene(with(guess, set::restitution(std::min(1.0, guess.restitution_lower))))),
        file("speed.csv", fmt::format("time,omega\n0,{}\n60,{}\n", first, last)));
    if (record.plate) {
      for (const double time : mark_times(scene_, record, *sensor.mark_jitter, random)) {
        marks += fmt::format("{:.6f}\n", time);
      }
      arguments += fmt::format(" --marks '{}'", file("marks.csv", marks));
    }
    const Call result = call("identify", arguments, true);  // a record may have no knocks
    if (result.output.empty() || result.code != 0) return;
    const Json answer = Json::parse(result.output);
    if (!answer["complete"] || !answer["contradictions"].empty()) {
      fault("identify", "exit code {}", result.code);
    }
  }

  /// Compares certain regimes with simulations at a random speed and just inside their borders.
  void compare(const char* command, const Json& all) {
    MachineDraw draw(seed_ + 8'000'000);
    const std::size_t every = (all.size() + most_regimes - 1) / most_regimes;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Json& regime = all[i];
      const double from = regime["from"], to = regime["to"], inside = 1e-5;
      const double random = draw.even_logarithm(from, to);
      const bool chosen = i % every == 0 || regime["most_per_turn"] <= quiet_per_turn;
      if (!regime["certain"] || !chosen || to < from * (1 + 3 * inside)) continue;
      for (const double omega : {from * (1 + inside), random, to * (1 - inside)}) {
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

  void compare_at(const char* command, const Json& regime, double omega) {
    const double least = regime["least_per_turn"], most = regime["most_per_turn"];
    std::pair<double, double> counted;
    const auto agrees = [&](const std::pair<double, double>& found) {
      counted = found;
      return counted.first >= least && counted.second <= most;
    };
    if (is_disturbed(scene_)) {
      for (const int settling : {20, 300, 3000}) {  // elastic carriers settle slowly
        if (agrees(counted_at_phases(scene_, omega, settling))) return;
      }
      // Several motions may be possible: on the wall where it rests if its speed rises slowly.
      const std::vector<Regime> known = regimes_of(scene_, {slowest, omega * (1 + 1e-9)});
      const double wall = known.back().last.orbit.start_position;
      if (agrees(counted_at_phases(with(scene_, set::start(wall, 0)), omega, 300))) return;
    } else {
      const double periodic = counted_in_periods(scene_, omega, regime["turns"], most);
      if (periodic == most) return;
      counted = {periodic, periodic};
    }
    ++wrong_;
    fmt::print(
        "machine {}: {}: at {:.9g} rad/s {:.6g} to {:.6g} collisions a turn, said {} to {}\n",
        seed_, command, omega, counted.first, counted.second, least, most);
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
