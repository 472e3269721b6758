#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// Results of a search for a problem's values, by name; empty if no point is feasible.
using Findings = std::map<std::string, double>;

/// A problem whose best value, and possibly other values, is not known yet. A campaign searches for
/// them at its start and keeps the findings in its store.
struct SearchedProblem {
  std::string family;
  Problem problem;  ///< name, box and formulations; its values may be wrong
  std::function<Findings()> search;
  std::function<Problem(const Findings&)>
      with;  ///< the complete problem; findings must not be empty
};

}  // namespace ricochet
