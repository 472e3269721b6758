#include "problems/carrier_track/check/push.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline oracle {

namespace {

using Real = long double;
using Polynomial = std::array<Real, 3>;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real unlimited = std::numeric_limits<Real>::infinity();

Polynomial times(Real factor, Polynomial p) {
  for (Real& x : p) x *= factor;
  return p;
}

/// A polynomial of degree 2 about another point.
Polynomial shifted(const Polynomial& a, Real u) {
  return {a[0] + u * (a[1] + u * a[2]), a[1] + 2 * u * a[2], a[2]};
}

/// The driver plate from a time on: alpha + omega u + slope u^2 / 2.
struct PlateLeg {
  Real from, alpha, omega, slope;
};

std::vector<PlateLeg> plate_legs(const Scene& scene) {
  const Real phase = scene.phase;
  if (scene.profile.empty()) return {{0, phase, scene.omega, 0}};
  std::vector<PlateLeg> legs = {{0, phase, scene.profile.front().omega, 0}};
  for (std::size_t k = 0; k < scene.profile.size(); ++k) {
    const auto& [time, omega] = scene.profile[k];
    const PlateLeg& last = legs.back();
    const Real since = time - last.from;
    PlateLeg leg{time, last.alpha + since * (last.omega + last.slope * since / 2), omega, 0};
    if (k + 1 < scene.profile.size()) {
      const auto& next = scene.profile[k + 1];
      leg.slope = (static_cast<Real>(next.omega) - omega) / (static_cast<Real>(next.time) - time);
    }
    if (since > 0) {
      legs.push_back(leg);
    } else {
      legs.back() = leg;
    }
  }
  for (PlateLeg& leg : legs) leg.alpha = std::remainder(leg.alpha, 2 * pi);
  return legs;
}

PushPiece piece_of(const Scene& scene, const PlateLeg& leg) {
  PushPiece piece{leg.from, {}};
  const auto add = [&](const Polynomial& amplitude, const Polynomial& phase) {
    const auto zero = [](Real x) { return static_cast<double>(x) == 0; };
    if (std::ranges::all_of(amplitude, zero)) return;
    piece.terms.push_back({amplitude, phase});
  };
  const auto ahead = [&](Real by) { return Polynomial{leg.alpha + by, leg.omega, leg.slope / 2}; };
  const Polynomial square = {leg.omega * leg.omega, 2 * leg.omega * leg.slope,
                             leg.slope * leg.slope};
  const Real centrifugal = scene.centrifugal_mass_radius;
  Polynomial steady = {};
  Real plate = -static_cast<Real>(scene.slider_mass_radius);
  if (scene.centrifugal == Centrifugal::projected) plate += centrifugal;
  if (scene.centrifugal == Centrifugal::inward) steady = times(-centrifugal, square);
  if (scene.centrifugal == Centrifugal::outward) steady = times(centrifugal, square);
  if (!scene.pull_rotates) steady[0] -= scene.pull;
  add(steady, {});
  add(times(plate, square), ahead(0));
  // -omega' sin alpha = -omega' cos(alpha - pi / 2)
  add({-scene.slider_mass_radius * leg.slope, 0, 0}, ahead(-pi / 2));
  if (scene.pull_rotates) add({-scene.pull, 0, 0}, ahead(scene.pull_phase));
  const Real frequency = scene.disturbance_frequency;
  add({scene.disturbance, 0, 0},
      {std::remainder(scene.disturbance_phase + frequency * leg.from, 2 * pi), frequency, 0});
  return piece;
}

}  // namespace

std::vector<PushPiece> applied_force(const Scene& scene) {
  std::vector<PushPiece> pieces;
  for (const PlateLeg& leg : plate_legs(scene)) {
    if (leg.from < duration_of(scene)) pieces.push_back(piece_of(scene, leg));
  }
  return pieces;
}

namespace {

/// By how much the phases may turn within one power series [rad]. With 36 terms the rest is below
/// the last bit: 3^36 / 36! = 4e-25 where a phase is linear; where it is a pure square, 17 powers
/// of it are kept, and 0.5^18 / 18! = 6e-22.
constexpr Real longest_turn(const Polynomial& phase) {
  return phase[2] == 0 ? 3 : 0.5L;
}

/// Bounds on the derivatives of order 0 to 3 of a term, for u up to `length` [s].
std::array<Real, 4> bounds_of(const PushTerm& term, Real length) {
  const auto& [a, p] = term;
  const Real a0 = std::abs(a[0]) + length * (std::abs(a[1]) + length * std::abs(a[2]));
  const Real a1 = std::abs(a[1]) + 2 * length * std::abs(a[2]);
  const Real a2 = 2 * std::abs(a[2]);
  const Real w = std::abs(p[1]) + 2 * length * std::abs(p[2]);
  const Real r = 2 * std::abs(p[2]);
  return {a0, a1 + a0 * w, a2 + 2 * a1 * w + a0 * (w * w + r),
          3 * a2 * w + 3 * a1 * (w * w + r) + a0 * (w * w * w + 3 * w * r)};
}

/// The same for the sum of waves of constant amplitude and frequency, order 1 to 3; infinite for
/// others. As phasors: relative to the first, a wave turns by the difference of frequencies. So the
/// sum is at most its length at the start plus the chords of these turns.
Real bound_of_waves(const std::vector<PushTerm>& terms, int order, Real length) {
  std::complex<Real> at_start = 0;
  Real chords = 0, first = 0;
  for (const auto& [a, p] : terms) {
    if (a[1] != 0 || a[2] != 0 || p[2] != 0) return unlimited;
    if (p[1] == 0) continue;
    if (first == 0) first = p[1];
    const Real size = a[0] * std::pow(p[1], static_cast<Real>(order));
    at_start += size * std::complex<Real>(std::cos(p[0]), std::sin(p[0]));
    chords += std::abs(size * (p[1] - first)) * length;
  }
  return std::abs(at_start) + chords;
}

/// How long it takes a phase with these derivatives to turn by `turn`, at least.
Real time_to_turn(Real rate, Real second, Real turn) {
  if (rate == 0 && second == 0) return unlimited;
  return 2 * turn / (rate + std::sqrt(rate * rate + 4 * second * turn));
}

}  // namespace

Push::Push(std::vector<PushPiece> force, long double mass, long double until)
    : pieces_(std::move(force)), piece_(unlimited) {
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    std::vector<PushTerm>& terms = pieces_[k].terms;
    const Real end = k + 1 < pieces_.size() ? std::min(pieces_[k + 1].from, until) : until;
    const Real length = std::max(end - pieces_[k].from, 0.0L);
    std::array<Real, 4> sum{};
    for (PushTerm& term : terms) {
      for (Real& x : term.amplitude) x /= mass;
      const auto bounds = bounds_of(term, length);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += bounds[i];
      const auto& p = term.phase;
      const Real fastest = std::abs(p[1]) + 2 * length * std::abs(p[2]);
      angle_ = std::max(angle_, std::abs(p[0]) + length * fastest);
      if (fastest > 0) piece_ = std::min(piece_, 0.25L / fastest);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sizes_[i] = std::max(sizes_[i], sum[i]);
      if (i > 0) sum[i] = std::min(sum[i], bound_of_waves(terms, static_cast<int>(i), length));
      bounds_[i] = std::max(bounds_[i], sum[i]);
    }
  }
}

long double Push::noise(int order) const {
  const Real operations = 64;
  return std::numeric_limits<Real>::epsilon() * (operations + 2 * angle_) *
         sizes_[static_cast<std::size_t>(order)];
}

const PushPiece& Push::at(long double time) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](Real t, const PushPiece& p) { return t < p.from; });
  return *(after - 1);
}

long double Push::smooth_until(long double time) const {
  const PushPiece* next = &at(time) + 1;
  return next == pieces_.data() + pieces_.size() ? unlimited : next->from;
}

long double Push::known_until(long double time) const {
  const PushPiece& piece = at(time);
  Real reach = unlimited;
  for (const PushTerm& term : piece.terms) {
    const auto phase = shifted(term.phase, time - piece.from);
    reach =
        std::min(reach, time_to_turn(std::abs(phase[1]), std::abs(phase[2]), longest_turn(phase)));
  }
  return std::min(time + reach, smooth_until(time));
}

PushFrom::PushFrom(const Push& push, long double start) {
  constexpr std::size_t terms = std::tuple_size_v<decltype(series_)> - 2;
  static const std::array<Real, terms + 2> inverse = [] {  // 1 / n; divisions are slow
    std::array<Real, terms + 2> list{};
    for (std::size_t n = 1; n < list.size(); ++n) list[n] = 1 / static_cast<Real>(n);
    return list;
  }();
  std::array<Real, terms> acceleration{}, sine, cosine;
  const PushPiece& piece = push.at(start);
  for (const PushTerm& term : piece.terms) {
    const auto a = shifted(term.amplitude, start - piece.from);
    const auto p = shifted(term.phase, start - piece.from);
    // The series of the sine and the cosine of p0 + p1 h + p2 h^2, from their derivatives.
    sine.fill(0);
    cosine.fill(0);
    sine[0] = std::sin(p[0]);
    cosine[0] = std::cos(p[0]);
    for (std::size_t n = 1; n < terms && (p[1] != 0 || p[2] != 0); ++n) {
      const Real before_sine = n > 1 ? sine[n - 2] : 0;
      const Real before_cosine = n > 1 ? cosine[n - 2] : 0;
      sine[n] = (p[1] * cosine[n - 1] + 2 * p[2] * before_cosine) * inverse[n];
      cosine[n] = -(p[1] * sine[n - 1] + 2 * p[2] * before_sine) * inverse[n];
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (a[i] == 0) continue;
      for (std::size_t n = i; n < terms; ++n) acceleration[n] += a[i] * cosine[n - i];
    }
  }
  for (std::size_t n = 0; n < terms; ++n) {
    series_[n + 2] = acceleration[n] * inverse[n + 1] * inverse[n + 2];
  }
}

Pushed PushFrom::after(long double elapsed) const {
  std::array<Real, 5> sum{};  // the distance and its derivatives, of order k over k!, by Horner
  for (std::size_t n = series_.size(); n-- > 0;) {
    for (std::size_t k = sum.size(); --k > 0;) sum[k] = sum[k] * elapsed + sum[k - 1];
    sum[0] = sum[0] * elapsed + series_[n];
  }
  return {sum[0], sum[1], 2 * sum[2], 6 * sum[3], 24 * sum[4]};
}

}  // namespace ricochet::carrier_track::inline oracle
