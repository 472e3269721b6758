#include "problems/carrier_track/problems/default_machine.h"

#include <fmt/format.h>

#include <sstream>

#include "embedded/default_machine_text.h"
#include "ricochet/scene.h"
#include "src/core/fnv_hash.h"

namespace ricochet::carrier_track::inline problems {

const Scene& default_machine() {
  static const Scene machine = parse_scene(embedded::default_machine_text,
                                           "problems/carrier_track/problems/default_machine.toml");
  return machine;
}

const std::string& default_machine_hash() {
  static const std::string digits = [] {
    FnvHash hash;
    std::istringstream lines(write_scene(default_machine()));
    for (std::string line; std::getline(lines, line);) hash.add(line.substr(0, line.find("  #")));
    return fmt::format("{:016x}", hash.value());
  }();
  return digits;
}

}  // namespace ricochet::carrier_track::inline problems
