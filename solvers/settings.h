#pragma once

namespace ricochet {

/// Which settings a solver runs with. Both are reported, under different names: a solver tuned on
/// the problems of this suite has an unfair advantage over one that is not.
enum class Settings {
  own,   ///< the defaults of its library or its authors
  tuned  ///< the settings that did best in a sweep on this suite
};

}  // namespace ricochet
