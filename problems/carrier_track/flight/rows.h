#pragma once

#include <experimental/simd>
#include <type_traits>

namespace ricochet::carrier_track::inline flight {

/// Numbers of several bodies side by side, processed by one instruction: a Row is a
/// std::experimental::simd of double. The code for rows repeats the code for single numbers
/// operation by operation, so that the bits are the same.
namespace stdx = std::experimental;

template <class Row>
using MaskOf = typename Row::mask_type;

template <class Row>
[[gnu::always_inline]] inline Row select(const MaskOf<Row>& which,
                                         const std::type_identity_t<Row>& yes, Row no) {
  stdx::where(which, no) = yes;
  return no;
}

/// std::min and std::max, with the same result for NaN.
template <class Row>
[[gnu::always_inline]] inline Row least(const Row& a, const Row& b) {
  return select(b < a, b, a);
}
template <class Row>
[[gnu::always_inline]] inline Row most(const Row& a, const Row& b) {
  return select(a < b, b, a);
}

}  // namespace ricochet::carrier_track::inline flight
