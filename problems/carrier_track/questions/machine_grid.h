#pragma once

#include <string>
#include <vector>

#include "problems/family.h"

namespace ricochet::carrier_track::inline questions {

/// What is varied from machine to machine around a case of the paper; a list that is empty leaves
/// the case's own.
struct MachineLevels {
  std::vector<double> restitution = {};    ///< of both walls
  std::vector<double> friction = {};       ///< coefficient
  std::vector<double> disturbance = {};    ///< [N]
  std::vector<std::string> fidelity = {};  ///< "impact", "compliant" or "planar"
};

/// The families of questions asked of machines around a case of the paper, one for every
/// combination of levels. "C1-r0.5-f0.2-d1" is one with restitution 0.5, friction 0.2 and a
/// disturbance of 1 N, "C1-r0.5-f0.2-d1-planar" the same where levels of fidelity are named: then
/// questions have the factor "fidelity", 0, 1 or 2 in the order above. A compliant wall has the law
/// of exact restitution, and the planar carrier as much room across as along, with a pull across as
/// strong as along: so every constant means the same at all of them. Quiet limits are found as
/// `ricochet threshold` does, at the level of the machine, for compliant walls by every tenth
/// speed, as best values are to be (scan_step): a simulation takes a thousand times as long.
/// Best values are not known: see with_scanned_best. Throws InputError for an unknown case or
/// level, or a machine that is none.
std::vector<Family> grid_families(const std::string& around, const MachineLevels& levels);

}  // namespace ricochet::carrier_track::inline questions
