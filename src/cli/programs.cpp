#include "src/cli/programs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ricochet/error.h"
#include "solvers/outside/outside.h"
#include "src/core/progress.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {

std::vector<std::string> programs_of(const Plan& plan) {
  std::vector<std::string> programs;
  for (const PlanPart& part : plan.parts) {
    for (const std::string& text : part.solvers) {
      const bool known = std::find(programs.begin(), programs.end(), text) != programs.end();
      if (!known && outside::is_outside(text)) programs.push_back(text);
    }
  }
  return programs;
}

Catalogue catalogue_that_starts_nothing() {
  Catalogue catalogue = studies::whole_catalogue();
  catalogue.own_solver = outside::unstarted_solver;
  return catalogue;
}

void announce_programs(const std::vector<std::string>& programs, bool allowed,
                       const std::string& origin) {
  if (programs.empty()) return;
  if (!allowed) {
    throw InputError(
        fmt::format("{}: names programs, which run with your rights: {}; add --allow-programs if "
                    "you trust them",
                    origin, fmt::join(programs, "; ")));
  }
  for (const std::string& program : programs) Progress::announce("starts " + program);
}

}  // namespace ricochet::cli
