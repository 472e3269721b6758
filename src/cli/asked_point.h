#pragma once

#include <string>

#include "ricochet/problem.h"

namespace ricochet::cli {

/// The content of a line of JSON: `[1, 2]`, `{"x": [1, 2]}` or `{"x": [1, 2], "derivatives": true,
/// "residuals": true}`.
struct AskedPoint {
  Vector x;
  bool derivatives;        ///< of all that is requested, including the residuals
  bool residuals = false;  ///< in addition to objective and constraints
};

/// Parses the point of a line, of the problem's dimension; `derivatives` is the default if the line
/// does not have that key. Throws InputError, which does not name the line.
AskedPoint parse_asked_point(const std::string& line, const Problem& problem, bool derivatives);

}  // namespace ricochet::cli
