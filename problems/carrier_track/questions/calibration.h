#pragma once

#include <string>
#include <vector>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/paper/open_constants.h"
#include "src/core/problem.h"
#include "src/core/question.h"

namespace ricochet::carrier_track::inline questions {

/// Which constants a fit may move, and what the others are held at.
struct Freedom {
  Reading reading;
  std::vector<Open> freed;
  Constants held;
};

/// All that the reading has a use for.
Freedom full_freedom(const Reading& reading);

/// The constants that a fit has moved, from their natural values on; the others as it holds them.
Freedom forgotten(const Reading& reading, const std::vector<Open>& freed,
                  const Constants& constants);

/// The problem of finding the open constants: minimise the misfit over the freed ones, each as its
/// place within its bounds, in [0, 1]. Its residuals are those of the smooth misfit of
/// `default_width`; it is judged by the misfit. It starts from the held constants.
Problem calibration_problem(const Freedom& freedom, const std::string& left_out = "");

/// The calibration of a reading: the constants that were fitted, from their natural values on, with
/// the others as the reading holds them.
Question calibration_question(const FittedReading& fitted);

/// The constants of a point of that problem.
Constants constants_at(const Freedom& freedom, const Vector& x);

/// The point of that problem for these constants, where they lie within the bounds.
Vector point_of(const Freedom& freedom, const Constants& constants);

}  // namespace ricochet::carrier_track::inline questions
