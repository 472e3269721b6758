#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/searched_problem.h"
#include "src/core/option_value.h"

namespace ricochet::carrier_track::inline problems {

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

}  // namespace ricochet::carrier_track::inline problems
