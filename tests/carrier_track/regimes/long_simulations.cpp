#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <exception>
#include <tuple>

#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "tests/carrier_track/regimes/machines.h"

/// How often regimes are wrong, by long simulations of random machines, FIRST to LAST:
///
///   ricochet_regimes_check undisturbed|scan|disturbed FIRST LAST [THREADS]
///
/// undisturbed: of each certain regime at a random speed and 1e-6 inside both borders; scan: at
/// speeds 0.1 % apart; disturbed: at and beside every border and in the middle of every regime, at
/// many phases and over many turns, of the cases C5 to C12 too if FIRST is 1.
namespace ricochet::carrier_track {
namespace {

constexpr double slowest = 0.3, fastest = 18;  // [rad/s]

/// What was looked at, and what was wrong.
std::atomic<int> machines, failed;
std::atomic<int> regimes_found, uncertain;  // and how many of them are not certain
std::atomic<int> speeds;                    // that were compared
std::atomic<int> wrong, wrong_uncertain;    // of these, in a certain regime, and in another
std::atomic<int> wide;                      // where a regime has a count that no simulation has

void print_tally() {
  fmt::print(
      "{} machines ({} failed), {} regimes ({} not certain), {} speeds: {} wrong in a certain "
      "regime, {} in others; {} wider than the simulations\n",
      machines.load(), failed.load(), regimes_found.load(), uncertain.load(), speeds.load(),
      wrong.load(), wrong_uncertain.load(), wide.load());
  std::fflush(stdout);
}

/// A machine and what is found of it.
class Check {
 public:
  Check(std::string name, const Scene& machine)
      : name_(std::move(name)),
        machine_(machine),
        regimes_(regimes_of(machine, {slowest, fastest})) {
    regimes_found += static_cast<int>(regimes_.size());
    uncertain += static_cast<int>(std::ranges::count(regimes_, false, &Regime::certain));
  }

  /// Compares each certain regime at three speeds.
  void undisturbed(std::uint64_t seed) {
    look_into_each(regimes_, seed, [&](const Regime& regime, double omega, const Scene& orbit) {
      const auto counted_after = [&](double factor) {
        return collisions_in_the_long_run(brought(orbit, omega, factor), omega, 300,
                                          whole_periods(regime));
      };
      double counted = counted_after(1.01);
      // Where several motions are possible, long steps may lead to another one.
      if (counted != regime.collisions_per_turn) counted = counted_after(1.0003);
      compare(regime, omega, counted, counted);
    });
  }

  /// Compares with a speed that rises in even steps.
  void scan() {
    look_evenly(machine_, regimes_, [&](const Regime& regime, double omega, double counted) {
      // The turns may not be a multiple of the period.
      const bool alike = std::abs(regime.collisions_per_turn - counted) < 0.026;
      compare(regime, omega, alike ? regime.least_per_turn : counted,
              alike ? regime.most_per_turn : counted);
    });
  }

  /// Compares at borders, beside them, and in the middle between them.
  void disturbed() {
    for (const Regime& regime : regimes_) {
      at_phases_and_in_time(0.5 * (regime.from + regime.to));
      for (const double away : {-1e-3, -1e-5, 1e-5, 1e-3}) {
        const double omega = regime.to * (1 + away);
        if (omega > slowest && omega < fastest) at_phases_and_in_time(omega);
      }
    }
  }

 private:
  void at_phases_and_in_time(double omega) {
    const Regime& regime = regime_at(regimes_, omega);
    const DisturbedMotion motion =
        disturbed_motion(with(machine_, set::fidelity(Fidelity::impact), set::omega(omega)));
    std::vector<int> counts;
    if (motion.settled && motion.moves) {
      const auto [least, most] = extremes_of(motion, 2000);
      counts = {least, most};
    }
    // From the machine's own start, which turns that begin at the same angle of the plate forget.
    const Scene there =
        with(motion.machine, set::start(machine_.start_position, machine_.start_velocity));
    for (const auto& one : observed_turns(there, {&there.disturbance_phase, 1}, 60, 1000)) {
      counts.push_back(one.collisions);
    }
    const auto [least, most] = std::ranges::minmax(counts);
    compare(regime, omega, least, most);
  }

  void compare(const Regime& regime, double omega, double least, double most) {
    ++speeds;
    if (least >= regime.least_per_turn && most <= regime.most_per_turn) {
      wide += least > regime.least_per_turn || most < regime.most_per_turn ? 1 : 0;
      return;
    }
    ++(regime.certain ? wrong : wrong_uncertain);
    fmt::print("{} at {:.9g}: {:.4g} to {:.4g} collisions a turn, said {:.4g} to {:.4g}{}\n", name_,
               omega, least, most, regime.least_per_turn, regime.most_per_turn,
               regime.certain ? "" : ", not certain");
  }

  std::string name_;
  Scene machine_;
  std::vector<Regime> regimes_;
};

int run(const std::vector<std::string>& arguments) {
  const std::string kind = arguments.at(0);
  const auto first = static_cast<std::uint64_t>(std::stoll(arguments.at(1)));
  const auto last = static_cast<std::uint64_t>(std::stoll(arguments.at(2)));
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      arguments.size() > 3 ? static_cast<std::size_t>(std::stoi(arguments[3])) : 1);
  std::vector<std::tuple<std::string, Scene, std::uint64_t>> all;
  for (const Case& one : all_cases()) {
    const Scene scene = case_scene(one.id);
    if (kind == "disturbed" && first == 1 && is_disturbed(scene))
      all.emplace_back(one.id, scene, 0);
  }
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    all.emplace_back(fmt::format("machine {}", seed),
                     kind == "disturbed" ? random_disturbed_machine(seed) : random_machine(seed),
                     seed);
  }
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t k) {
    const auto& [name, machine, seed] = all[k];
    try {
      Check check(name, machine);
      if (kind == "undisturbed") check.undisturbed(seed);
      if (kind == "scan") check.scan();
      if (kind == "disturbed") check.disturbed();
    } catch (const std::exception& error) {
      ++failed;
      fmt::print("{}: {}\n", name, error.what());
    }
    if (++machines % 100 == 0) print_tally();
  });
  print_tally();
  return wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace ricochet::carrier_track

int main(int argc, char** argv) {
  return ricochet::carrier_track::run({argv + 1, argv + argc});
}
