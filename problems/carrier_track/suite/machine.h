#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/suite/cases.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"
#include "src/core/instance.h"
#include "src/core/names.h"

namespace ricochet::carrier_track::inline problems {

/// A machine at any speed, from which problems are made.
struct Machine {
  std::string id;                   ///< of the case, e.g. "C1", or "scene"
  Scene scene;                      ///< valid; its own speed is not used
  double quiet_limit = 0;           ///< a count up to this is quiet
  std::optional<double> threshold;  ///< [rad/s] as claimed, or found if there is no claim
  std::string default_hash;         ///< default_machine_hash() for the suite's cases; else empty
};

/// A case with these constants; the quiet limit is that of its claim.
Machine machine_of(const Case& a_case, const Scene& constants);

/// A machine "scene" from the user's file; limit and threshold are of quiet_rule_of(). `origin`
/// names the scene, for instance its file. Throws InputError for a speed profile: a threshold is
/// defined for constant speeds.
Machine machine_of(const Scene& scene, const std::string& origin);

/// The cases of the default machine.
std::vector<Machine> all_machines();

/// [rad/s]; a speed at which the machine is probably loud: 1.25 thresholds, or 6 rad/s without a
/// threshold.
inline double loud_speed(const Machine& machine) {
  return machine.threshold ? 1.25 * *machine.threshold : 6.0;
}

/// The level at which a smooth surrogate is compared with the quiet limit: half a collision above
/// the highest quiet count. Counts are integers, and an impact counts half at margin 0: so the
/// surrogate crosses this level, apart from the tails of other impacts, exactly where the count
/// leaves the limit.
inline double half_level(double quiet_limit) {
  return std::floor(quiet_limit) + 0.5;
}

/// Returns true if simulations of the scene can carry derivatives: those with hard walls in one
/// direction can.
inline bool carries_derivatives(const Scene& scene) {
  return scene.fidelity == Fidelity::impact;
}

/// What may vary from machine to machine around a case of the paper: "restitution" of both walls,
/// "friction" (coefficient), "disturbance" [N], which are numbers >= 0, and "fidelity", with its
/// texts: "impact", "compliant" or "planar".
std::map<std::string, std::vector<std::string>> machine_keys();

/// The levels of what varies, by key. A missing key keeps the case's value.
using MachineLevels = std::map<std::string, std::vector<OptionValue>>;

/// The problems of one variable for machines around a case of the paper, one machine for every
/// combination of levels. "C1-r0.5-f0.2-d1" has restitution 0.5, friction 0.2 and a disturbance of
/// 1 N; "C1-r0.5-f0.2-d1-planar" is the same if levels of fidelity are given. The problems then
/// have the factor "fidelity": 0, 1 or 2 for impact, compliant and planar. Every constant has the
/// same meaning at all levels: a compliant wall has the law of exact restitution, and the planar
/// carrier has the same clearance and pull across as along. A search finds the quiet limit as
/// `ricochet threshold` does, at the machine's fidelity; for compliant walls, whose simulation
/// takes a thousand times as long, it scans every tenth speed. It finds the best value in the same
/// way (scan_step). The keys and levels must be allowed, see machine_keys().
///
/// With `scene`, the text of a machine file, the machines are those around it, and `around` is its
/// name: "mine-r0.3" has restitution 0.3 at both walls, and all else, the fidelity too, as in the
/// text; "mine" is the machine itself.
/// Throws InputError for an unknown case, a scene with the name of a case, or an invalid machine.
std::vector<SearchedProblem> grid_problems(const std::string& around, const MachineLevels& levels,
                                           const std::string& scene = "");

/// Largest relative difference of a constant of a drawn machine from the original.
inline constexpr double drawn_tolerance = 0.05;

/// A similar machine: every constant (see constants_of) times 0.95 to 1.05, independent and
/// uniform; restitution is at most 1. Quiet limit and threshold are kept; default_hash is cleared,
/// because best values do not carry over: see drawn_problem. Deterministic in id and number; "C1~3"
/// is number 3 around C1, and number 0 the machine itself. Throws std::invalid_argument for number
/// < 0.
Machine drawn_machine(Machine machine, int number);

/// The same problem of one variable for a machine drawn around its own, which is one of the cases.
/// Empty if it belongs to none of them or has several variables.
std::optional<SearchedProblem> drawn_problem(const Problem& problem, int number);

/// The machine of every case except for restitution, friction and disturbance:
/// default_machine.toml.
const Scene& default_machine();

/// Sixteen hexadecimal digits that change with any constant of the default machine. Best values are
/// stored with this hash and hold for this machine only.
const std::string& default_machine_hash();

// The problems of the carrier track, all from the single objective of count.h.

/// Every family of problems, for these machines.
std::vector<Family> families_of(const std::vector<Machine>& machines);

/// Every family of the cases in the default interpretation, and the calibration of that
/// interpretation.
std::vector<Family> case_families();

}  // namespace ricochet::carrier_track::inline problems
