#pragma once

#include <string>
#include <vector>

#include "src/core/question.h"

namespace ricochet {

/// Questions of one kind. What there is to say of them stands in reports/templates/families.toml.
struct Family {
  std::string name;  ///< what the names of its questions begin with, e.g. "top-speed"
  std::vector<Question> questions;
};

}  // namespace ricochet
