#include "problems/carrier_track/check/oracle/term_push.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ricochet::carrier_track::inline oracle {
namespace {

constexpr long double unlimited = std::numeric_limits<long double>::infinity();

/// By how much the phases may turn within one power series [rad]. With 36 terms the rest is below
/// the last bit, even where a phase is a pure square: then 17 powers of it are kept, and
/// 0.5^18 / 18! = 6e-22.
constexpr long double longest_turn = 0.5L;

/// A polynomial of degree 2 about another point.
std::array<long double, 3> shifted(const std::array<long double, 3>& a, long double u) {
  return {a[0] + u * (a[1] + u * a[2]), a[1] + 2 * u * a[2], a[2]};
}

/// Bounds on the derivatives of order 0 to 3 of a term, for u up to `length` [s].
std::array<long double, 4> bounds_of(const PushTerm& term, long double length) {
  const auto& [a, p] = term;
  const long double a0 = std::abs(a[0]) + length * (std::abs(a[1]) + length * std::abs(a[2]));
  const long double a1 = std::abs(a[1]) + 2 * length * std::abs(a[2]);
  const long double a2 = 2 * std::abs(a[2]);
  const long double w = std::abs(p[1]) + 2 * length * std::abs(p[2]);
  const long double r = 2 * std::abs(p[2]);
  return {a0, a1 + a0 * w, a2 + 2 * a1 * w + a0 * (w * w + r),
          3 * a2 * w + 3 * a1 * (w * w + r) + a0 * (w * w * w + 3 * w * r)};
}

/// How long it takes a phase with these derivatives to turn by `turn`, at least.
long double time_to_turn(long double rate, long double second, long double turn) {
  if (rate == 0 && second == 0) return unlimited;
  return 2 * turn / (rate + std::sqrt(rate * rate + 4 * second * turn));
}

}  // namespace

TermPush::TermPush(std::vector<Piece> pieces, long double until)
    : pieces_(std::move(pieces)), piece_(unlimited) {
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const long double end = k + 1 < pieces_.size() ? std::min(pieces_[k + 1].from, until) : until;
    const long double length = std::max(end - pieces_[k].from, 0.0L);
    std::array<long double, 4> sum{};
    for (const PushTerm& term : pieces_[k].terms) {
      const auto bounds = bounds_of(term, length);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += bounds[i];
      const auto& p = term.phase;
      const long double fastest = std::abs(p[1]) + 2 * length * std::abs(p[2]);
      angle_ = std::max(angle_, std::abs(p[0]) + length * fastest);
      if (fastest > 0) piece_ = std::min(piece_, longest_turn / 2 / fastest);
    }
    for (std::size_t i = 0; i < sum.size(); ++i) sizes_[i] = std::max(sizes_[i], sum[i]);
  }
}

long double TermPush::bound(int power, long double /*until*/) const {
  return sizes_[static_cast<std::size_t>(power)];
}

long double TermPush::noise(int power, long double /*until*/) const {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  const long double operations = 64;
  return last_bit * (operations + 2 * angle_) * sizes_[static_cast<std::size_t>(power)];
}

std::size_t TermPush::index_at(long double time) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), time,
                                      [](long double t, const Piece& p) { return t < p.from; });
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

const TermPush::Piece& TermPush::at(long double time) const {
  return pieces_[index_at(time)];
}

long double TermPush::smooth_until(long double time) const {
  const std::size_t next = index_at(time) + 1;
  return next < pieces_.size() ? pieces_[next].from : unlimited;
}

long double TermPush::known_until(long double time) const {
  const Piece& piece = at(time);
  long double reach = unlimited;
  for (const PushTerm& term : piece.terms) {
    const auto phase = shifted(term.phase, time - piece.from);
    reach = std::min(reach, time_to_turn(std::abs(phase[1]), std::abs(phase[2]), longest_turn));
  }
  return std::min(time + reach, smooth_until(time));
}

TermPushFrom::TermPushFrom(const TermPush& push, long double start) {
  const TermPush::Piece& piece = push.at(start);
  const long double u = start - piece.from;
  for (const PushTerm& term : piece.terms) {
    const auto a = shifted(term.amplitude, u);
    const auto p = shifted(term.phase, u);
    if (p[1] == 0 && p[2] == 0) {
      for (std::size_t i = 0; i < a.size(); ++i) series_[i] += a[i] * std::cos(p[0]);
      continue;
    }
    // The series of the sine and the cosine of p0 + p1 h + p2 h^2, from their derivatives.
    std::array<long double, std::tuple_size_v<decltype(series_)>> sine, cosine;
    sine[0] = std::sin(p[0]);
    cosine[0] = std::cos(p[0]);
    for (std::size_t n = 1; n < series_.size(); ++n) {
      const auto order = static_cast<long double>(n);
      const long double before_sine = n > 1 ? sine[n - 2] : 0;
      const long double before_cosine = n > 1 ? cosine[n - 2] : 0;
      sine[n] = (p[1] * cosine[n - 1] + 2 * p[2] * before_cosine) / order;
      cosine[n] = -(p[1] * sine[n - 1] + 2 * p[2] * before_sine) / order;
    }
    for (std::size_t n = 0; n < series_.size(); ++n) {
      for (std::size_t i = 0; i < std::min<std::size_t>(a.size(), n + 1); ++i) {
        series_[n] += a[i] * cosine[n - i];
      }
    }
  }
}

Pushed TermPushFrom::after(long double elapsed) const {
  Pushed sum{};
  for (std::size_t n = series_.size(); n-- > 0;) {
    const auto order = static_cast<long double>(n);
    const long double c = series_[n];
    if (n > 1) sum.snap = sum.snap * elapsed + order * (order - 1) * c;
    if (n > 0) sum.jerk = sum.jerk * elapsed + order * c;
    sum.acceleration = sum.acceleration * elapsed + c;
    sum.speed = sum.speed * elapsed + c / (order + 1);
    sum.distance = sum.distance * elapsed + c / ((order + 1) * (order + 2));
  }
  sum.speed *= elapsed;
  sum.distance *= elapsed * elapsed;
  return sum;
}

}  // namespace ricochet::carrier_track::inline oracle
