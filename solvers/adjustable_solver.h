#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/core/option_value.h"
#include "src/core/solver.h"

namespace ricochet {

/// Something about a solver that a plan may change: a number, or, where there are words, one of
/// them.
struct SolverOption {
  std::string name;
  std::string usual;  ///< what holds where it is not given, for people
  double least = 0, most = 0;
  bool whole = false;
  bool without_least = false, without_most = false;  ///< the end itself is not allowed
  std::vector<std::string> words = {};               ///< "*": any

  bool allows(const OptionValue& value) const;
  std::string range() const;  ///< e.g. "a whole number from 1 to 1000000"
};

SolverOption real_option(const std::string& name, double least, double most, double usual);

/// Up to a million.
SolverOption whole_option(const std::string& name, int least, int usual);

/// One whose usual value hangs on the problem, in words.
SolverOption whole_option(const std::string& name, int least, const std::string& usual);

/// A solver of the suite that can be made with other options than its own.
struct AdjustableSolver {
  std::string name;
  std::vector<SolverOption> options;
  /// With these in place of its own, which are all allowed; with none it is the suite's solver.
  /// Throws std::invalid_argument where they do not go together.
  std::function<Solver(const GivenOptions&)> with;
};

/// What is given, or else the usual.
double number_of(const GivenOptions& given, const std::string& name, double usual);
int whole_of(const GivenOptions& given, const std::string& name, int usual);

}  // namespace ricochet
