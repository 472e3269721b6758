// Compiled twice, once with the instructions of AVX2 and RICOCHET_WIDE_LANES. The widths of the
// rows differ, so that no template is made of the same types in both.
#include "problems/carrier_track/models/lane_flight.h"

#include <limits>
#include <type_traits>

#include "problems/carrier_track/events/search_rows.h"
#include "problems/carrier_track/flight/flight_rows.h"

namespace ricochet::carrier_track::inline models {
namespace {

using Native = stdx::native_simd<double>;
using Row = std::conditional_t<(Native::size() <= Lanes::size), Native,
                               stdx::simd<double, stdx::simd_abi::deduce_t<double, Lanes::size>>>;
using Mask = MaskOf<Row>;

/// The lanes from `first` on, as many as a row has.
template <int harmonics>
class LaneFlight {
 public:
  LaneFlight(Lanes& lanes, std::size_t first) : lanes_(lanes), first_(first) {}

  void fly() {
    SearchRows<Row, harmonics> search(
        start(), direction_, direction_ * ((wall_ - load(lanes_.origin)) - load(lanes_.offset)),
        duration_ - load(lanes_.time));
    search.run();
    const FlightRows<Row, harmonics>& there = search.there;
    const Mask struck = search.arrival;
    const Mask done = search.turn || struck;
    const Row before = load(lanes_.time);
    const Row after =
        select(search.time >= duration_ - before, duration_, Row(before + search.time));
    const Row speed = most(Row(direction_ * there.velocity), Row(0.0));
    store(done, after, lanes_.time);
    store(done, search.time, lanes_.elapsed);
    store(done, load(lanes_.evaluations) + search.evaluations, lanes_.evaluations);
    store(done, select(struck, 0.0, there.position), lanes_.offset);
    store(done, select(struck, rebound(speed), Row(0.0)), lanes_.velocity);
    store(done, select(struck, -direction_, release(there)), lanes_.direction);
    store(struck, wall_, lanes_.origin);
    store(done, select(struck, direction_, Row(0.0)), lanes_.wall);
    store(struck, speed, lanes_.speed);
    for (std::size_t h = 0; h < harmonics; ++h) {
      store(done, there.cosine[h], lanes_.cosine[h]);
      store(done, there.sine[h], lanes_.sine[h]);
    }
    store(Mask(true), select(struck, Lanes::struck, select(search.turn, Lanes::turned, Row(0.0))),
          lanes_.event);
  }

 private:
  Row load(const Lanes::Row& row) const { return Row(row.data() + first_, stdx::vector_aligned); }

  void store(const Mask& which, const Row& values, Lanes::Row& row) const {
    select(which, values, load(row)).copy_to(row.data() + first_, stdx::vector_aligned);
  }

  FlightRows<Row, harmonics> start() const {
    FlightRows<Row, harmonics> flight{load(lanes_.offset),
                                      load(lanes_.velocity),
                                      load(lanes_.steady) + select(rising_, -friction_, friction_),
                                      {},
                                      {},
                                      {}};
    for (std::size_t h = 0; h < harmonics; ++h) {
      flight.cosine[h] = load(lanes_.cosine[h]);
      flight.sine[h] = load(lanes_.sine[h]);
      flight.frequency[h] = load(lanes_.frequency[h]);
    }
    return flight;
  }

  /// The velocity of a body that has struck the wall ahead; see HardWallMotion::strike.
  Row rebound(const Row& speed) const {
    const Row restitution =
        select(rising_, load(lanes_.restitution_upper), load(lanes_.restitution_lower));
    const Row rebound = restitution * speed;
    return select(rising_, 0.0 - rebound, rebound);
  }

  /// Where a body that has turned goes; see HardWallMotion::direction_of_release.
  Row release(const FlightRows<Row, harmonics>& there) const {
    const Row steady = load(lanes_.steady);
    const Row push = there.acceleration(steady);
    const Row hold =
        friction_ + 4 * std::numeric_limits<double>::epsilon() * (friction_ + there.size(steady));
    return select(push > hold, 1.0, select(push < -hold, -1.0, Row(0.0)));
  }

  Lanes& lanes_;
  std::size_t first_;
  Row direction_ = load(lanes_.direction);
  Mask rising_ = direction_ > 0.0;
  Row friction_ = load(lanes_.friction);
  Row wall_ = select(rising_, load(lanes_.wall_upper), load(lanes_.wall_lower));
  Row duration_ = load(lanes_.duration);
};

}  // namespace

#ifdef RICOCHET_WIDE_LANES
void fly_wide(Lanes& lanes) {
#else
void fly_plain(Lanes& lanes) {
#endif
  for (std::size_t first = 0; first < Lanes::size; first += Row::size()) {
    if (lanes.harmonics == 1) {
      LaneFlight<1>(lanes, first).fly();
    } else {
      LaneFlight<2>(lanes, first).fly();
    }
  }
}

}  // namespace ricochet::carrier_track::inline models
