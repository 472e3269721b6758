#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>

namespace ricochet {

/// The common key of runs that differ only in instance and number: the unit of comparison.
struct Cell {
  std::string problem;
  std::string formulation;             ///< see Problem::name_of
  std::string perturbation = "plain";  ///< see all_perturbations()
  std::string solver;
  std::int64_t budget = 0;           ///< evaluations for each variable
  std::string gradient_price = "n";  ///< see PlanPart::gradient_prices

  auto operator<=>(const Cell&) const = default;
};

/// Identifies a run: two runs with the same key have the same results, whenever and wherever they
/// are made.
struct RunKey {
  Cell cell;
  int instance = 1;  ///< >= 0; 0 is the problem as stated
  int run = 0;       ///< >= 0; the number of the seed

  auto operator<=>(const RunKey&) const = default;
};

/// The key in words, for messages.
std::string name_of(const RunKey& key);

/// The key as one word, for command lines:
/// problem/formulation/perturbation/solver/budget/price/instance/run.
std::string address_of(const RunKey& key);

/// The key of such a word; nothing if it is none.
std::optional<RunKey> key_at(const std::string& address);

}  // namespace ricochet
