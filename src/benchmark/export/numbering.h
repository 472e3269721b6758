#pragma once

#include <map>
#include <set>
#include <string>

#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// What readers of other suites need instead of names: numbers of functions, and names that are
/// valid as file names and in lists. The names hold only letters, digits and -._+, have at most 100
/// characters, and are different for different things.
class Numbering {
 public:
  explicit Numbering(const CampaignDescription& description);

  /// 1, 2, ... Problems with 5 or 6 variables come first, because COCO opens only those, and only
  /// 24; the others follow in the order of the description.
  int function_id(const std::string& problem) const { return functions_.at(problem).id; }
  const std::string& function_name(const std::string& problem) const {
    return functions_.at(problem).name;
  }

  /// The name of the cell's algorithm. An algorithm is everything of a cell except its problem:
  /// solver, formulation, perturbation, gradient price and budget (runs with another budget are
  /// other runs).
  const std::string& algorithm(const Cell& cell);

 private:
  struct Function {
    int id;
    std::string name;
  };
  std::map<std::string, Function> functions_;
  std::map<Cell, std::string> algorithms_;  ///< of cells without their problem
  std::set<std::string> taken_;
};

}  // namespace ricochet::exports
