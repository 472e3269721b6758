#include "src/core/seed.h"

#include <string>

#include "src/core/fnv_hash.h"

namespace ricochet {

std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run) {
  FnvHash hash;
  for (const std::string_view text : {problem, solver, std::string_view(std::to_string(instance)),
                                      std::string_view(std::to_string(run))}) {
    hash.add(text);
    hash.add("\xFF");
  }
  return hash.value();
}

}  // namespace ricochet
