#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/machine.h"
#include "problems/family.h"

/// Machines whose staircases rise and fall. The paper's machines are quiet up to some speed and
/// loud beyond it, but for a few collisions: bisection finds their fastest quiet speed. These,
/// found by a search among random ones (studies/best_values/hard_search.h), are quiet again in a
/// narrow pocket far beyond.
namespace ricochet::carrier_track::inline questions {

/// What makes the fastest quiet speed hard to find; speeds and widths in rad/s, of a scan of the
/// whole range.
struct Hardness {
  int pockets = 0;             ///< of quiet speeds, no narrower than speed_tolerance
  double first_end = 0;        ///< the fastest speed of the first of them
  double last_begin = 0;       ///< the slowest speed of the last, whose end is the best
  double loud_before = 0;      ///< from there down to the next quiet speed
  double bisection_gap = 0;    ///< from where bisection ends, begun in the middle, to the best
  double bisection_share = 0;  ///< of 255 places to begin in, from which bisection finds the best

  bool operator==(const Hardness&) const = default;
};

struct HardMachine {
  std::string around;  ///< the case whose constants it was drawn around
  int draw = 0;        ///< the number of that draw
  Machine machine;     ///< "01", "02", ..., the hardest first
  BestKnown best;      ///< of the fastest quiet speed
  Hardness hardness;
};

/// What was found, and the reading of the paper around whose cases it was drawn: that of the day.
struct HardMachines {
  FittedReading reading;
  std::vector<HardMachine> machines;
};

/// The share of the box in the pocket whose end is the best: who asks uniformly gets there once in
/// so many times.
double pocket_share(const HardMachine& hard);

/// Throws InputError, with origin and name, for a text that holds none.
HardMachines parse_hard_machines(const std::string& text, const std::string& origin);

/// The text that is read back to the same reading and machines, bit for bit.
std::string write_hard_machines(const HardMachines& found);

/// hard_machines.toml, which `ricochet best-values --hard-machines` regenerates.
const HardMachines& found_hard_machines();

/// Those of it.
const std::vector<HardMachine>& hard_machines();

/// The fastest quiet speed of such a machine, "hard-top-speed-<id>", with its best value.
Question hard_top_speed_question(const HardMachine& hard);

/// The question of every hard machine.
Family hard_family();

}  // namespace ricochet::carrier_track::inline questions
