#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace ricochet {

/// What runs have in common that differ in instance and number only: what is compared in the end.
struct Cell {
  std::string question;
  std::string form;               ///< in which it is shown; see Question::name_of
  std::string feature = "plain";  ///< what is done to what is shown; see all_features
  std::string solver;
  std::int64_t budget = 0;           ///< evaluations for each variable
  std::string gradient_price = "n";  ///< see GradientPrice in plan.h

  auto operator<=>(const Cell&) const = default;
};

/// Names a run: two with the same key are the same run, whenever and wherever they are made.
struct RunKey {
  Cell cell;
  int instance = 1;  ///< >= 0; 0 is the question as stated
  int run = 0;       ///< >= 0; another one is another seed

  auto operator<=>(const RunKey&) const = default;
};

/// In words, for messages.
std::string name_of(const RunKey& key);

}  // namespace ricochet
