#include "problems/carrier_track/models/lanes.h"

#include "problems/carrier_track/models/lane_flight.h"

namespace ricochet::carrier_track::inline models {
namespace {

auto widest() {
#if defined(__x86_64__) && !defined(__clang__)
  // All AVX-512 processors except the first few support all of these.
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    return fly_avx512;
  }
#endif
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return fly_avx2;
#endif
  return fly_plain;
}

}  // namespace

void fly(Lanes& lanes) {
  static const auto chosen = widest();
  chosen(lanes);
}

}  // namespace ricochet::carrier_track::inline models
