#pragma once

#include "ricochet/vector.h"

/// Explosion amplitudes: how far sparks lie from their firework.
namespace ricochet::fireworks {

/// The unit of the amplitudes.
enum class AmplitudeUnit {
  of_x,        ///< the units of x, whatever the width of the box
  box_widths,  ///< the width of the box, coordinate by coordinate
};

/// Equation (25): amplitude * (f_i - best + epsilon) / (sum of f - best + epsilon). `fitness` holds
/// a finite number for each firework, lower is better. The amplitude of the best one is almost 0.
Vector explosion_amplitudes(const Vector& fitness, double amplitude, double epsilon);

/// The lower bound of EFWA's amplitudes, in their unit.
struct AmplitudeFloor {
  double first = 0;  ///< at the beginning, A_init
  double last = 0;   ///< when the budget is spent, A_final; 0 <= last <= first

  /// A_init - (A_init - A_final) / E sqrt((2 E - t) t) after t of E evaluations, 0 <= t <= E
  /// (Zheng, Janecek and Tan, CEC 2013, doi 10.1109/CEC.2013.6557813).
  double after(double evaluations, double budget) const;
};

/// An amplitude that grows while its firework improves, and declines otherwise (Zheng, Janecek, Li
/// and Tan, CEC 2014, doi 10.1109/CEC.2014.6900485).
struct AmplitudeSteps {
  double growth = 1.2;   ///< >= 1
  double decline = 0.9;  ///< in (0, 1]

  double next(double amplitude, bool better) const {
    return amplitude * (better ? growth : decline);
  }
};

/// Throws std::invalid_argument for steps out of range.
void check(const AmplitudeSteps& steps);

}  // namespace ricochet::fireworks
