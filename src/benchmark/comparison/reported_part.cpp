#include "src/studies/contest/reported_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ricochet::studies::contest {
namespace {

bool repeats_another(const Campaign& campaign, std::size_t part) {
  for (std::size_t first = 0; first < part; ++first) {
    if (repetition_of(campaign, first) == part) return true;
  }
  return false;
}

/// The cells that a part asks for; it has some.
std::vector<const PlannedCell*> cells_of(const Campaign& campaign, std::size_t part) {
  std::vector<const PlannedCell*> cells;
  for (const PlannedCell& cell : campaign.cells()) {
    const auto& parts = cell.parts;
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) cells.push_back(&cell);
  }
  return cells;
}

bool asks_several_features(const std::vector<const PlannedCell*>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](const PlannedCell* cell) {
    return cell->cell.feature != cells.front()->cell.feature;
  });
}

}  // namespace

std::vector<ReportedPart> reported_parts(const Campaign& campaign) {
  std::vector<ReportedPart> reported;
  std::set<std::string> known;
  for (std::size_t part = 0; part < campaign.plan().parts.size(); ++part) {
    if (repeats_another(campaign, part)) continue;
    const std::vector<const PlannedCell*> cells = cells_of(campaign, part);
    ReportedPart mine{part, {.part = part}, {}};
    const auto asks = [&](const std::string Cell::*what, const std::string& value) {
      return std::any_of(cells.begin(), cells.end(),
                         [&](const PlannedCell* cell) { return cell->cell.*what == value; });
    };
    const Cell& first = cells.front()->cell;
    if (!asks(&Cell::feature, mine.usual.feature)) mine.usual.feature = first.feature;
    if (!asks(&Cell::gradient_price, mine.usual.gradient_price)) {
      mine.usual.gradient_price = first.gradient_price;
    }
    const PlanPart& asked = campaign.plan().parts[part];
    const bool varies =
        asked.gradient_prices.size() > 1 || !asked.widths.empty() || asks_several_features(cells);
    const std::string suffix = asked.name.empty() ? fmt::format("part-{}", part + 1) : asked.name;
    for (const PlannedCell* cell : cells) {
      const std::string& family = campaign.family_of(cell->question);
      const bool again = known.contains(family);
      mine.families[family] = again ? fmt::format("{}-{}", family, suffix) : family;
      if (again && varies) mine.asked_again.insert(family);
    }
    for (const auto& [family, name] : mine.families) known.insert(family);
    reported.push_back(std::move(mine));
  }
  return reported;
}

std::optional<std::size_t> repetition_of(const Campaign& campaign, std::size_t part) {
  const auto& parts = campaign.plan().parts;
  for (std::size_t other = 0; other < parts.size(); ++other) {
    const bool same = parts[other].questions == parts[part].questions &&
                      parts[other].machines == parts[part].machines &&
                      parts[other].solvers == parts[part].solvers &&
                      parts[other].least_variables == parts[part].least_variables &&
                      parts[other].most_variables == parts[part].most_variables &&
                      parts[other].instances == parts[part].instances;
    if (same && parts[other].seeds > 1) return other;
  }
  return std::nullopt;
}

}  // namespace ricochet::studies::contest
