#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/benchmark/analysis/comparison.h"

namespace ricochet::studies::comparison {

using namespace ricochet::comparison;

/// A part of a campaign's plan, as it is reported.
struct ReportedPart {
  std::size_t part;
  /// The conditions that are compared within it: no perturbation and a gradient at the price n if
  /// it has these, else its first perturbation and price.
  Conditions usual;
  /// Names of its families; if an earlier part has a family too, the part's name or number is
  /// added.
  std::map<std::string, std::string> families;
  /// Families, by their own names, that an earlier part has too and in which this one varies
  /// perturbations, prices or smoothing parameters: they are not rated a second time.
  std::set<std::string> asked_again = {};
  /// The parts with the same problems that have several seeds (may be this one), or drawn machines.
  std::optional<std::size_t> repetition = {}, drawn = {};
};

/// The name of a part of a plan: its own, or "part-1" after its number, counted from 0.
std::string name_of_part(const PlanPart& part, std::size_t number);

/// Returns the parts without those that only repeat another one with more seeds or on drawn
/// machines, and without those that relocate the optimum.
std::vector<ReportedPart> reported_parts(const Campaign& campaign);

}  // namespace ricochet::studies::comparison
