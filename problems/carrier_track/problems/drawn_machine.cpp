#include "problems/carrier_track/problems/drawn_machine.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "problems/carrier_track/answer/sensitivity.h"
#include "problems/carrier_track/problems/families.h"
#include "problems/carrier_track/problems/scanned_best.h"
#include "ricochet/random.h"
#include "src/core/seed.h"

namespace ricochet::carrier_track::inline problems {

Machine drawn_machine(Machine machine, int number) {
  if (number < 0) throw std::invalid_argument(fmt::format("machine {}: must be >= 0", number));
  if (number == 0) return machine;
  Random random(seed_of(machine.id, "drawn machine", number, 0));
  for (const std::string& key : constants_of(machine.scene)) {
    const double change = drawn_tolerance * (2 * uniform(random) - 1);
    machine.scene = scaled(std::move(machine.scene), key, 1 + change);
  }
  machine.id += fmt::format("~{}", number);
  machine.default_hash.clear();
  return machine;
}

std::optional<SearchedProblem> drawn_problem(const Problem& problem, int number) {
  if (problem.dimension() != 1) return std::nullopt;
  static const std::vector<Machine> cases = all_machines();
  for (const Machine& machine : cases) {
    if (machine.id != problem.machine) continue;
    const Machine drawn = drawn_machine(machine, number);
    const std::string name = problem.name + drawn.id.substr(machine.id.size());
    for (const Family& family : families_of({drawn})) {
      for (const Problem& asked : family.problems) {
        if (asked.name != name) continue;
        return SearchedProblem{
            family.name, asked, [asked] { return scanned_best(asked); },
            [asked](const Findings& found) { return with_scanned_best(asked, found); }};
      }
    }
  }
  return std::nullopt;
}

}  // namespace ricochet::carrier_track::inline problems
