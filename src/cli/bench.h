#pragma once

#include <string>
#include <vector>

namespace ricochet::cli {

/// Runs the speed measurements; `arguments` are Google Benchmark's own, such as
/// --benchmark_filter=simulate. With `json` it prints Google Benchmark's own JSON.
int bench(std::vector<std::string> arguments, bool json);

}  // namespace ricochet::cli
