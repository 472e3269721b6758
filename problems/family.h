#pragma once

#include <string>
#include <vector>

#include "src/core/question.h"

namespace ricochet {

/// Questions of one kind, and what there is to say of them; text is plain.
struct Family {
  std::string name;         ///< what the names of its questions begin with, e.g. "top-speed"
  std::string title;        ///< e.g. "The fastest quiet speed"
  std::string asks;         ///< what it asks
  std::string formula;      ///< objective and variables, in words
  std::string constraints;  ///< empty where it has none
  std::string surrogate;    ///< what is shown where it is smoothed; empty where it never is
  std::string derivatives;  ///< empty where it has none
  std::string instances;    ///< what the questions differ in
  std::string users;        ///< who would use it
  std::vector<Question> questions;
};

}  // namespace ricochet
