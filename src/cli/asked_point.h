#pragma once

#include <string>

#include "src/core/problem.h"

namespace ricochet::cli {

/// What a line of JSON asks for: `[1, 2]`, `{"x": [1, 2]}` or
/// `{"x": [1, 2], "derivatives": true, "residuals": true}`.
struct AskedPoint {
  Vector x;
  bool derivatives;        ///< of what is asked for, the residuals included
  bool residuals = false;  ///< beside objective and constraints
};

/// The point of a line, of the problem's dimension; `derivatives` holds where the line says nothing
/// of them. Throws InputError, which does not name the line.
AskedPoint parse_asked_point(const std::string& line, const Problem& problem, bool derivatives);

}  // namespace ricochet::cli
