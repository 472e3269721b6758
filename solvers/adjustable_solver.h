#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "src/core/names.h"

namespace ricochet {

/// An option of a solver that a plan may change: a number, or one of `words` if there are any.
struct SolverOption {
  std::string name;
  std::string usual;  ///< the default, as text for people
  double least = 0, most = 0;
  bool whole = false;
  bool without_least = false, without_most = false;  ///< the bound itself is excluded
  std::vector<std::string> words = {};               ///< allowed words; "*": any

  bool allows(const OptionValue& value) const;
  std::string range() const;  ///< e.g. "a whole number from 1 to 1000000"
};

SolverOption real_option(const std::string& name, double least, double most, double usual);

/// At most a million.
SolverOption whole_option(const std::string& name, int least, int usual);

/// An option whose default depends on the problem; `usual` describes it in words.
SolverOption whole_option(const std::string& name, int least, const std::string& usual);

/// A solver of the suite that can be made with other options than its defaults.
struct AdjustableSolver {
  std::string name;
  std::vector<SolverOption> options;
  /// Makes the solver with these options, whose values are allowed; with none it is the suite's
  /// solver. Throws std::invalid_argument if the options contradict each other, or this build of
  /// the solver cannot use one.
  std::function<Solver(const GivenOptions&)> with;
};

/// The given value, or `usual` if there is none.
double number_of(const GivenOptions& given, const std::string& name, double usual);
int whole_of(const GivenOptions& given, const std::string& name, int usual);

/// Which settings a solver runs with. Both are reported, under different names: a solver tuned on
/// the problems of this suite has an unfair advantage over one that is not.
enum class Settings {
  own,   ///< the defaults of its library or its authors
  tuned  ///< the settings that did best in a sweep on this suite
};

/// Every solver of this build that has options.
std::vector<AdjustableSolver> adjustable_solvers();

/// The solver `of` under another name and with these options instead of its defaults; its version
/// lists them. Throws InputError if there is no such solver with options, for an unknown option,
/// and for a value that is not allowed.
Solver varied(const std::string& of, const std::string& name, const GivenOptions& given);

/// The options of a solver. Throws InputError if there is no such solver with options.
std::vector<SolverOption> options_of(const std::string& solver);

}  // namespace ricochet
