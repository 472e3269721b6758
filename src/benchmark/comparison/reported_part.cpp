#include "src/benchmark/comparison/reported_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace ricochet::studies::comparison {
namespace {

bool asks_the_same(const PlanPart& a, const PlanPart& b) {
  return a.problems == b.problems && a.machines == b.machines && a.solvers == b.solvers &&
         a.least_variables == b.least_variables && a.most_variables == b.most_variables;
}

/// Returns the first part with the same problems for which the predicate holds; it may be this one.
template <class IsSuch>
std::optional<std::size_t> companion_of(const std::vector<PlanPart>& parts, std::size_t part,
                                        const IsSuch& is_such) {
  for (std::size_t other = 0; other < parts.size(); ++other) {
    if (asks_the_same(parts[part], parts[other]) && is_such(parts[other])) return other;
  }
  return std::nullopt;
}

std::optional<std::size_t> repetition_of(const std::vector<PlanPart>& parts, std::size_t part) {
  return companion_of(parts, part, [&](const PlanPart& other) {
    return other.seeds > 1 && other.instances == parts[part].instances &&
           other.drawn_machines == parts[part].drawn_machines && !other.relocated_optimum;
  });
}

std::optional<std::size_t> drawn_of(const std::vector<PlanPart>& parts, std::size_t part) {
  if (parts[part].drawn_machines > 0) return std::nullopt;
  return companion_of(parts, part, [](const PlanPart& other) { return other.drawn_machines > 0; });
}

/// Returns the cells of a part; there is at least one.
std::vector<const PlannedCell*> cells_of(const Campaign& campaign, std::size_t part) {
  std::vector<const PlannedCell*> cells;
  for (const PlannedCell& cell : campaign.cells()) {
    const auto& parts = cell.parts;
    if (std::find(parts.begin(), parts.end(), part) != parts.end()) cells.push_back(&cell);
  }
  return cells;
}

bool asks_several_perturbations(const std::vector<const PlannedCell*>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](const PlannedCell* cell) {
    return cell->cell.perturbation != cells.front()->cell.perturbation;
  });
}

}  // namespace

std::string name_of_part(const PlanPart& part, std::size_t number) {
  return part.name.empty() ? fmt::format("part-{}", number + 1) : part.name;
}

std::vector<ReportedPart> reported_parts(const Campaign& campaign) {
  std::vector<ReportedPart> reported;
  std::set<std::string> known;
  std::set<std::size_t> companions;  // parts that only repeat another part
  const std::vector<PlanPart>& parts = campaign.plan().parts;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto drawn = drawn_of(parts, part);
    if (drawn && !parts[part].relocated_optimum) companions.insert(*drawn);
  }
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (companions.contains(part) || parts[part].relocated_optimum) continue;
    const auto repetition = repetition_of(parts, part);
    if (repetition) companions.insert(*repetition);
    const std::vector<const PlannedCell*> cells = cells_of(campaign, part);
    ReportedPart mine{part, {.part = part}, {}, {}, repetition, drawn_of(parts, part)};
    const auto asks = [&](const std::string Cell::*what, const std::string& value) {
      return std::any_of(cells.begin(), cells.end(),
                         [&](const PlannedCell* cell) { return cell->cell.*what == value; });
    };
    const Cell& first = cells.front()->cell;
    if (!asks(&Cell::perturbation, mine.usual.perturbation))
      mine.usual.perturbation = first.perturbation;
    if (!asks(&Cell::gradient_price, mine.usual.gradient_price)) {
      mine.usual.gradient_price = first.gradient_price;
    }
    const PlanPart& asked = parts[part];
    const bool varies = asked.gradient_prices.size() > 1 || !asked.smoothings.empty() ||
                        asks_several_perturbations(cells);
    const std::string suffix = name_of_part(asked, part);
    for (const PlannedCell* cell : cells) {
      const std::string& family = campaign.family_of(cell->problem);
      const bool again = known.contains(family);
      mine.families[family] = again ? fmt::format("{}-{}", family, suffix) : family;
      if (again && varies) mine.asked_again.insert(family);
    }
    for (const auto& [family, name] : mine.families) known.insert(family);
    reported.push_back(std::move(mine));
  }
  return reported;
}

}  // namespace ricochet::studies::comparison
