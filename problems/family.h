#pragma once

#include <string>
#include <vector>

#include "src/core/problem.h"

namespace ricochet {

/// Problems of one kind, and what there is to say of them; text is plain.
struct Family {
  std::string name;         ///< what the names of its problems begin with, e.g. "top-speed"
  std::string title;        ///< e.g. "The fastest quiet speed"
  std::string question;     ///< what it asks
  std::string formula;      ///< objective and variables, in words
  std::string constraints;  ///< empty where it has none
  std::string derivatives;  ///< empty where it has none
  std::string instances;    ///< what the problems differ in
  std::string users;        ///< who would use it
  /// The family whose problems, in the same order, have the same truth, shown in another way; its
  /// own name where there is none. One best value holds for both.
  std::string judged_as;
  std::vector<Problem> problems;
};

}  // namespace ricochet
