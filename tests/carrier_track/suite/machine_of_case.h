#pragma once

#include <string>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {

/// The machine of a case of the paper, as the exploratory scene has it.
inline Machine machine(const std::string& id) {
  return machine_of(find_case(id), exploratory_scene());
}

inline Vector at(double omega) {
  return Vector::Constant(1, omega);
}

}  // namespace ricochet::carrier_track
