#include <fmt/format.h>

#include <set>

#include "ricochet/solver.h"
#include "src/app/command_line.h"

namespace ricochet::cli {

std::string version() {
  std::set<std::string> libraries;
  for (const Solver& solver : all_solvers()) {
    if (!solver.version.starts_with("ricochet")) libraries.insert(solver.version);
  }
  return fmt::format("ricochet {} (commit {})\nlibraries: {}, {}\n", RICOCHET_VERSION,
                     RICOCHET_COMMIT, RICOCHET_LIBRARIES, fmt::join(libraries, ", "));
}

}  // namespace ricochet::cli
