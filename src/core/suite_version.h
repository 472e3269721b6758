#pragma once

namespace ricochet {

/// Version of the suite: problems, names and seeds. Stores, best values and fits of another version
/// are refused.
inline constexpr int suite_version = 3;

}  // namespace ricochet
