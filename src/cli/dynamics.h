#pragma once

#include <string>

namespace ricochet::cli {

struct DynamicsOptions {
  bool quick = false;
  std::string out = "reports/dynamics";
};

/// Computes contact laws, methods and levels of the model and writes the report. Returns the exit
/// code.
int dynamics(const DynamicsOptions& options);

}  // namespace ricochet::cli
