#include "src/core/seed.h"

#include <string>

namespace ricochet {

std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run,
                      std::string_view shown) {
  // FNV-1a, 64 bit: offset basis and prime of the published algorithm.
  std::uint64_t hash = 14695981039346656037ULL;
  const auto add = [&hash](std::string_view text) {
    for (const char c : text) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    }
    hash = (hash ^ 0xFFU) * 1099511628211ULL;
  };
  add(problem);
  add(solver);
  add(std::to_string(instance));
  add(std::to_string(run));
  if (!shown.empty()) add(shown);
  return hash;
}

}  // namespace ricochet
