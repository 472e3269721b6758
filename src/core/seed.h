#pragma once

#include <cstdint>
#include <string_view>

namespace ricochet {

/// A seed that depends on the identity of a run, not on when or where it executes: a 64-bit FNV-1a
/// hash of the names and numbers, each closed by a separator. `shown`, unless empty, distinguishes
/// the formulations of the same problem.
std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run,
                      std::string_view shown = {});

/// The 64-bit hash FNV-1a with its published offset basis and prime. Source: Fowler, Noll, Vo,
/// Eastlake, The FNV Non-Cryptographic Hash Algorithm, RFC 9923.
class FnvHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    }
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Version of the suite: problems, names and seeds. Stores, best values and fits of another version
/// are refused.
inline constexpr int suite_version = 3;

}  // namespace ricochet
