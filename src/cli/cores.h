#pragma once

namespace ricochet::cli {

/// Number of runs made at once.
int cores();

}  // namespace ricochet::cli
