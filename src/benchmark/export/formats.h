#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/store/store.h"

namespace ricochet::exports {

/// A way to write what a store holds for other tools.
struct Format {
  std::string name;
  std::string about;  ///< one line
  /// Writes files into the folder, which is there and empty. Throws InputError where the store is
  /// damaged, OutputError where the disk takes no more.
  std::function<void(const Store&, const std::filesystem::path& folder)> write;
};

std::vector<Format> all_formats();

}  // namespace ricochet::exports
