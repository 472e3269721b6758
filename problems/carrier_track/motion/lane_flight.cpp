// Compiled once for each instruction set, each time into a function of another name. The widths of
// the rows differ, so that no template has the same types in two of them.
#include "problems/carrier_track/motion/lane_flight.h"

#include <limits>
#include <type_traits>

#include "problems/carrier_track/motion/event_rows.h"
#include "problems/carrier_track/motion/flight_rows.h"

#ifndef RICOCHET_FLY
#define RICOCHET_FLY fly_plain
#endif

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

  /// Returns true if every body has turned or rested, and moves on.
  bool run() {
    const Mask moves = direction_ != 0.0;
    const Mask rests = !moves && load(lanes_.time) < duration_;
    store(Mask(true), Row(Lanes::none), lanes_.event);
    if (stdx::any_of(moves)) fly();
    // NOTE: with few resting bodies the caller handles each of them as fast as a row handles all.
    if (2 * stdx::popcount(rests) > static_cast<int>(Row::size())) rest(rests);
    const Row event = load(lanes_.event);
    const Mask moves_on = (event == Lanes::turned || event == Lanes::rested) &&
                          load(lanes_.direction) != 0.0 && load(lanes_.time) < duration_;
    return stdx::all_of(moves_on || !(moves || rests));
  }

 private:
  [[gnu::always_inline]] void fly() {
    SearchRows<Row, harmonics> search = next_event();
    const Mask far = search.run();
    land(search);
    if (stdx::any_of(far)) fly_far(far);
  }

  // NOTE: not inlined, because the compiler would keep all rows of the other case in memory.
  [[gnu::noinline]] void fly_far(const Mask& which) {
    SearchRows<Row, harmonics> search = next_event();
    search.run_far(which);
    land(search);
  }

  [[gnu::always_inline]] SearchRows<Row, harmonics> next_event() const {
    return {start(load(lanes_.steady) + select(rising_, -friction_, friction_)), direction_,
            direction_ * ((wall_ - load(lanes_.origin)) - load(lanes_.offset)),
            duration_ - load(lanes_.time)};
  }

  /// Sets the state of the bodies that have an event.
  [[gnu::always_inline]] void land(const SearchRows<Row, harmonics>& search) {
    const FlightRows<Row, harmonics>& there = search.there;
    const Mask struck = search.arrival;
    const Mask done = search.turn || struck;
    const Row speed = most(Row(direction_ * there.velocity), Row(0.0));
    pass(done, search.time, search.evaluations, there);
    store(done, select(struck, 0.0, there.position), lanes_.offset);
    store(done, select(struck, rebound(speed), Row(0.0)), lanes_.velocity);
    store(done, select(struck, -direction_, release(there)), lanes_.direction);
    store(struck, wall_, lanes_.origin);
    store(done, select(struck, direction_, Row(0.0)), lanes_.wall);
    store(struck, speed, lanes_.speed);
    store(done, select(struck, Lanes::struck, Row(Lanes::turned)), lanes_.event);
  }

  void rest(const Mask& which) {
    FlightRows<Row, harmonics> forces = start(load(lanes_.steady));
    const Row wall = load(lanes_.wall);
    ReleaseRows<Row, harmonics> release(forces, friction_, duration_ - load(lanes_.time));
    release.run(which, wall != 1.0, wall != -1.0);
    forces.advance(release.time);
    pass(which, release.time, release.evaluations, forces);
    store(which, release.direction, lanes_.direction);
    store(which, Row(Lanes::rested), lanes_.event);
  }

  /// Lets `time` [s] pass; afterwards the harmonics are those of `there`.
  [[gnu::always_inline]] void pass(const Mask& which, const Row& time, const Row& evaluations,
                                   const FlightRows<Row, harmonics>& there) {
    const Row before = load(lanes_.time);
    store(which, select(time >= duration_ - before, duration_, Row(before + time)), lanes_.time);
    store(which, time, lanes_.elapsed);
    store(which, load(lanes_.evaluations) + evaluations, lanes_.evaluations);
    for (std::size_t h = 0; h < harmonics; ++h) {
      store(which, there.cosine[h], lanes_.cosine[h]);
      store(which, there.sine[h], lanes_.sine[h]);
    }
  }

  Row load(const Lanes::Row& row) const { return Row(row.data() + first_, stdx::vector_aligned); }

  void store(const Mask& which, const Row& values, Lanes::Row& row) const {
    select(which, values, load(row)).copy_to(row.data() + first_, stdx::vector_aligned);
  }

  FlightRows<Row, harmonics> start(const Row& steady) const {
    FlightRows<Row, harmonics> flight{
        load(lanes_.offset), load(lanes_.velocity), steady, {}, {}, {}};
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

  /// The direction of a body after a turning point; see HardWallMotion::direction_of_release.
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

template <int harmonics>
void fly_row(Lanes& lanes, std::size_t first) {
  for (int i = 0; i < lanes.flights && LaneFlight<harmonics>(lanes, first).run(); ++i) continue;
}

}  // namespace

void RICOCHET_FLY(Lanes& lanes) {
  for (std::size_t first = 0; first < lanes.used; first += Row::size()) {
    lanes.harmonics == 1 ? fly_row<1>(lanes, first) : fly_row<2>(lanes, first);
  }
}

}  // namespace ricochet::carrier_track::inline models
