#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"

namespace ricochet::outside {

/// Whether the text is a user's solver, which outside_solver() would start: a shared library,
/// "./mine.so", or a program, "python3 mine.py" or "./mine". Otherwise, with neither a / nor a
/// space, it is the name of one of all_solvers(). Throws InputError if it is neither.
bool is_outside(const std::string& text);

/// A user's solver; nothing if `text` is a name. Starts the program, or loads the library in
/// another process, to learn what it claims. Throws InputError if it is no solver.
std::optional<Solver> outside_solver(const std::string& text);

/// As outside_solver(), but starts nothing: the solver is called `text`, accepts every problem and
/// cannot solve any.
std::optional<Solver> unstarted_solver(const std::string& text);

/// What is asked for at a point.
struct Wanted {
  bool derivatives = false;  ///< of all that is asked for, including the residuals
  bool residuals = false;
};

/// A request of the line protocol: one point, or a list of points.
struct AskedPoints {
  std::vector<Vector> points;
  bool list = false;  ///< a list, also one of a single point: the answer has lists, too
  Wanted wanted;
};

/// Reads the points under `key` of the object, `[1, 2]` or `[[1, 2], [3, 4]]`, and its keys
/// "derivatives" and "residuals", which are true or false; `wanted` has the values of those that
/// are missing. A number that is null becomes NaN. Throws InputError, which does not name the line,
/// for anything else.
AskedPoints asked_points(const nlohmann::ordered_json& request, const std::string& key,
                         Eigen::Index dimension, Wanted wanted = {});

/// Reads a point, which messages call `name`.
Vector asked_point(const nlohmann::ordered_json& numbers, const std::string& name,
                   Eigen::Index dimension);

/// The answer to a request by those for its points, at least one: that of the point or, for a list,
/// an object in which each key has the list of what the points have there.
nlohmann::ordered_json joined(std::vector<nlohmann::ordered_json> answers, bool list);

}  // namespace ricochet::outside
