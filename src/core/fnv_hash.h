#pragma once

#include <cstdint>
#include <string_view>

namespace ricochet {

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

}  // namespace ricochet
