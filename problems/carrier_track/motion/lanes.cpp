#include "problems/carrier_track/motion/lanes.h"

#include "problems/carrier_track/motion/lane_flight.h"

namespace ricochet::carrier_track::inline models {

namespace {

using Fly = void (*)(Lanes&);

/// For up to four bodies: longer rows take longer.
Fly short_enough_for_four() {
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx2")) return fly_avx2;
#endif
  return fly_plain;
}

Fly widest() {
#if defined(__x86_64__) && !defined(__clang__)
  // All AVX-512 processors except the first few support all of these.
  if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw")) {
    return fly_avx512;
  }
#endif
  return short_enough_for_four();
}

}  // namespace

void fly(Lanes& lanes) {
  static const Fly wide = widest();
  static const Fly narrow = short_enough_for_four();
  (lanes.used > 4 ? wide : narrow)(lanes);
}

}  // namespace ricochet::carrier_track::inline models
