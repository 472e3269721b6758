#pragma once

#include <string>

namespace ricochet::cli {

struct ExportOptions {
  std::string store;  ///< SQLite file
  std::string format;
  std::string out;  ///< folder, empty or missing
};

/// Exports a campaign's store to the formats of other tools.
int export_store(const ExportOptions& options);

}  // namespace ricochet::cli
