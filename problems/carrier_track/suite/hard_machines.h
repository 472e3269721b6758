#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"

/// Machines whose staircases rise and fall. The paper's machines, apart from a few collisions, are
/// quiet up to some speed and loud beyond it, so bisection finds their top speed in the window.
/// These machines, found by a search among random ones (src/studies/best_values/best_values.h), are
/// quiet again in a narrow quiet interval at a much higher speed.
namespace ricochet::carrier_track::inline problems {

/// Measures of how hard the top speed in the window is to find; speeds and widths in rad/s, from a
/// scan of the whole range.
struct Hardness {
  int quiet_intervals = 0;     ///< of quiet speeds, no narrower than speed_tolerance
  double first_end = 0;        ///< the fastest speed of the first interval
  double last_begin = 0;       ///< the slowest speed of the last, whose end is the best
  double loud_before = 0;      ///< width of the loud interval before it
  double bisection_gap = 0;    ///< distance of the best from bisection started in the middle
  double bisection_share = 0;  ///< share of 255 starts from which bisection finds the best

  bool operator==(const Hardness&) const = default;
};

struct HardMachine {
  std::string around;  ///< the case whose constants it was drawn around
  int draw = 0;        ///< the number of that draw
  Machine machine;     ///< "01", "02", ..., the hardest first
  BestKnown best = {.value = 0, .point = Vector::Zero(1), .provenance = ""};  ///< its speed
  Hardness hardness;
};

/// The machines found, and the interpretation of the paper at the time of the search, around whose
/// cases they were drawn.
struct HardMachines {
  Scene constants;
  std::vector<HardMachine> machines;
};

/// The width of the quiet interval whose end is the best, as a share of the box: the probability
/// that a uniform point lies in it.
double quiet_interval_share(const HardMachine& hard);

/// Throws InputError, with origin and name, for invalid text.
HardMachines parse_hard_machines(const std::string& text, const std::string& origin);

/// Returns text that parses back to the same interpretation and machines, bit for bit.
std::string write_hard_machines(const HardMachines& found);

/// The contents of hard_machines.toml, which `ricochet best-values --hard-machines` regenerates.
const HardMachines& found_hard_machines();

/// The machines of found_hard_machines().
const std::vector<HardMachine>& hard_machines();

/// The top speed in the window of a hard machine, "hard-top-speed-<id>", with its best value.
Problem hard_top_speed_problem(const HardMachine& hard);

/// The problem of every hard machine.
Family hard_family();

}  // namespace ricochet::carrier_track::inline problems
