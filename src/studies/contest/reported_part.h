#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "src/contest/stored_contest.h"

namespace ricochet::studies::contest {

using namespace ricochet::contest;

/// A part of a campaign's plan, as it is reported.
struct ReportedPart {
  std::size_t part;
  /// What is compared within it: nothing disturbed and a gradient at the price n, where it asks for
  /// that, else the first feature and price that it asks for.
  Conditions usual;
  /// How its families are called: by their names, with the part's name or number where a part
  /// before has them, too.
  std::map<std::string, std::string> families;
  /// Families, by their own names, that a part before has, too, while this one asks what features,
  /// prices or widths do to them: they are not rated once more.
  std::set<std::string> asked_again = {};
};

/// The parts but those that only repeat another one with more seeds.
std::vector<ReportedPart> reported_parts(const Campaign& campaign);

/// The part that asks for the same with several seeds, where there is one.
std::optional<std::size_t> repetition_of(const Campaign& campaign, std::size_t part);

}  // namespace ricochet::studies::contest
