#pragma once

#include <map>
#include <set>
#include <string>

#include "src/store/store.h"

namespace ricochet::exports {

/// What readers of other suites want instead of names: numbers of functions, and names that may
/// be those of files and stand in lists. They hold letters, digits and -._+ only, differ where
/// what they name does, and have at most 100 characters.
class Numbering {
 public:
  explicit Numbering(const CampaignDescription& description);

  /// 1, 2, ... Questions with 5 or 6 variables come first, else they stand as in the description:
  /// COCO opens only those, and only 24.
  int function_id(const std::string& question) const { return functions_.at(question).id; }
  const std::string& function_name(const std::string& question) const {
    return functions_.at(question).name;
  }

  /// Everything of a cell but its question makes an algorithm: solver, form, feature, gradient
  /// price and budget, as runs of another budget are other runs.
  const std::string& algorithm(const Cell& cell);

 private:
  struct Function {
    int id;
    std::string name;
  };
  std::map<std::string, Function> functions_;
  std::map<Cell, std::string> algorithms_;  ///< of cells without their question
  std::set<std::string> taken_;
};

}  // namespace ricochet::exports
