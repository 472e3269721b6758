#pragma once

namespace ricochet::cli {

/// Prints a scene of `verify`, as TOML or JSON, with the impacts that the library and the oracle
/// find, to look at a disagreement. Throws InputError for a negative index.
void show_hostile_scene(int seed, int index, bool json);

}  // namespace ricochet::cli
