#pragma once

namespace ricochet {

/// How a problem is presented to a solver: a property of a run, never of the problem or its name.
struct Formulation {
  double smoothing = 0;    ///< smoothing parameter of the surrogate, >= 0; 0: the true objective
  bool penalised = false;  ///< constraints are charged to the objective; see penalty.h

  bool operator==(const Formulation&) const = default;
};

}  // namespace ricochet
