#pragma once

#include <string>
#include <vector>

#include "problems/family.h"

namespace ricochet::studies::best_values {

/// Problems of one truth, shown in several ways: one best value holds for all of them.
struct Question {
  std::string name;            ///< of the problem that the others are judged as
  std::vector<Problem> forms;  ///< that problem first
};

/// Those of all families, in their order. Throws std::logic_error where a family is judged as one
/// that is not there, or has other problems.
std::vector<Question> questions_of(const std::vector<Family>& families);

}  // namespace ricochet::studies::best_values
