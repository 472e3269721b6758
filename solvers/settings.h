#pragma once

namespace ricochet {

/// Whose settings a solver runs with. Both stand in the tables, under names of their own: who was
/// tuned to the questions of this suite is no fair rival of who was not.
enum class Settings {
  own,   ///< those of its library, or of its authors
  tuned  ///< those that did best here, in a sweep
};

}  // namespace ricochet
