#pragma once

#include <string>
#include <vector>

namespace ricochet::cli {

struct EvaluateOptions {
  std::string problem;
  std::string scene_file;             ///< use this machine; empty: no machine of the user
  std::vector<std::string> settings;  ///< of --set
  std::string formulation;            ///< its name; empty: original
  int instance = 0;                   ///< 0: the original problem
  bool derivatives = false;           ///< return them, too, unless a line says otherwise
  bool replay = false;                ///< evaluate every point twice, and compare
  bool describe = false;              ///< describe the problem and evaluate nothing
};

/// Evaluates the problem for an external optimiser: reads a line of JSON with a point, or with a
/// list of points, on standard input and writes a line of JSON with the values on standard output.
/// Returns the exit code: 1 if a line was invalid, or if a point evaluated twice had two results.
int evaluate(const EvaluateOptions& options);

}  // namespace ricochet::cli
