#pragma once

#include <string>

#include "src/core/solver.h"

namespace ricochet::outside {

/// The solver that the shared library at `path`, which holds a /, exports as ricochet_plugin; see
/// include/ricochet/ricochet.h. Its name is the file's where it has none. The library stays until
/// the program ends. What its solver throws ends the run. Throws InputError where the file is no
/// library, or the library is no such solver.
Solver plugin(const std::string& path);

}  // namespace ricochet::outside
