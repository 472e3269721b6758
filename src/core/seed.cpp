#include "src/core/seed.h"

#include <string>

#include "src/core/fnv_hash.h"

namespace ricochet {

std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run) {
  FnvHash hash;
  const auto add = [&hash](std::string_view text) {
    hash.add(text);
    hash.add("\xFF");
  };
  add(problem);
  add(solver);
  add(std::to_string(instance));
  add(std::to_string(run));
  return hash.value();
}

}  // namespace ricochet
