#pragma once

#include <string>
#include <vector>

#include "problems/searched_problem.h"

namespace ricochet::carrier_track::inline problems {

/// The levels that vary from machine to machine around a case of the paper; an empty list keeps the
/// case's value.
struct MachineLevels {
  std::vector<double> restitution = {};    ///< of both walls
  std::vector<double> friction = {};       ///< coefficient
  std::vector<double> disturbance = {};    ///< [N]
  std::vector<std::string> fidelity = {};  ///< "impact", "compliant" or "planar"
};

/// The problems of one variable for machines around a case of the paper, one machine for every
/// combination of levels. "C1-r0.5-f0.2-d1" has restitution 0.5, friction 0.2 and a disturbance of
/// 1 N; "C1-r0.5-f0.2-d1-planar" is the same if levels of fidelity are given. The problems then
/// have the factor "fidelity": 0, 1 or 2 for impact, compliant and planar. Every constant has the
/// same meaning at all levels: a compliant wall has the law of exact restitution, and the planar
/// carrier has the same clearance and pull across as along. A search finds the quiet limit as
/// `ricochet threshold` does, at the machine's fidelity; for compliant walls, whose simulation
/// takes a thousand times as long, it scans every tenth speed. It finds the best value in the same
/// way (scan_step). Throws InputError for an unknown case or level, or an invalid machine.
std::vector<SearchedProblem> grid_problems(const std::string& around, const MachineLevels& levels);

}  // namespace ricochet::carrier_track::inline problems
