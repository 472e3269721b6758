#include "problems/carrier_track/check/push.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

namespace ricochet::carrier_track::inline oracle {

namespace {

/// theta - sin(theta), by its power series where the difference would cancel.
long double lag(long double theta) {
  if (std::abs(theta) > 0.5L) return theta - std::sin(theta);
  // 1 / (k (k + 1)), k = 4, 6, ...: the ratios of the terms.
  static constexpr std::array<long double, 7> ratio = {
      1 / 20.0L, 1 / 42.0L, 1 / 72.0L, 1 / 110.0L, 1 / 156.0L, 1 / 210.0L, 1 / 272.0L};
  const long double square = theta * theta;
  long double term = theta * square / 6;
  long double sum = term;
  for (const long double r : ratio) {
    term *= -square * r;
    sum += term;
    if (square < 1e-10L && r == ratio[1]) break;  // the next term is below the last bit
  }
  return sum;
}

}  // namespace

Push::Push(const Scene& scene) {
  if (!scene.profile.empty()) throw std::invalid_argument("the oracle knows no speed profile");
  const long double mass = scene.mass;
  const long double square = static_cast<long double>(scene.omega) * scene.omega;
  const long double centrifugal = scene.centrifugal_mass_radius * square;
  // Terms of the plate, along cos alpha and along sin alpha.
  long double cosine = -(scene.slider_mass_radius * square) / mass;
  long double sine = 0;
  if (scene.pull_rotates) {
    cosine -= scene.pull / mass * std::cos(static_cast<long double>(scene.pull_phase));
    sine += scene.pull / mass * std::sin(static_cast<long double>(scene.pull_phase));
  } else {
    steady -= scene.pull / mass;
  }
  if (scene.centrifugal == Centrifugal::projected) cosine += centrifugal / mass;
  if (scene.centrifugal == Centrifugal::inward) steady -= centrifugal / mass;
  if (scene.centrifugal == Centrifugal::outward) steady += centrifugal / mass;
  waves[0].frequency = scene.omega;
  waves[0].amplitude = std::copysign(std::hypot(cosine, sine), cosine);
  waves[0].phase = scene.phase - (cosine == 0 && sine == 0 ? 0.0L : std::atan(sine / cosine));
  waves[1].amplitude = scene.disturbance / mass;
  waves[1].frequency = scene.disturbance_frequency;
  waves[1].phase = scene.disturbance_phase;
  for (Wave& wave : waves) {
    if (wave.frequency > 0) continue;
    steady += wave.amplitude * std::cos(wave.phase);
    wave = {};
  }
}

long double Push::size(int power) const {
  long double sum = 0;
  for (const Wave& wave : waves) {
    long double size = std::abs(wave.amplitude);
    for (int i = 0; i < power; ++i) size *= wave.frequency;
    sum += size;
  }
  return sum;
}

long double Push::bound(int power, long double until) const {
  // As phasors: relative to the first, the second turns by the difference of frequencies. So the
  // sum is at most its length at time 0 plus the chord of that turn.
  const auto& [plate, disturbance] = waves;
  const long double first = plate.amplitude * std::pow(plate.frequency, power);
  const long double second = disturbance.amplitude * std::pow(disturbance.frequency, power);
  const long double angle = disturbance.phase - plate.phase;
  const long double at_start =
      std::hypot(first + second * std::cos(angle), second * std::sin(angle));
  const long double turn = std::abs(disturbance.frequency - plate.frequency) * until;
  return std::min(size(power), at_start + std::abs(second) * turn);
}

long double Push::noise(int power, long double until) const {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  const long double operations = 16;
  const long double own = power == 0 ? strength() : size(power);
  return last_bit * (operations * own + 2 * until * size(power + 1));
}

long double Push::piece() const {
  long double piece = std::numeric_limits<long double>::infinity();
  for (const Wave& wave : waves) {
    if (wave.amplitude != 0) piece = std::min(piece, 0.25L / wave.frequency);
  }
  return piece;
}

PushFrom::PushFrom(const Push& push, long double start) : push_(push), angle_{} {
  for (std::size_t i = 0; i < angle_.size(); ++i) {
    const Push::Wave& wave = push.waves[i];
    const long double angle = wave.frequency * start + wave.phase;
    angle_[i] = {std::sin(angle), std::cos(angle)};
  }
}

Pushed PushFrom::after(long double elapsed) const {
  const long double steady = push_.steady;
  Pushed sum{steady * elapsed * elapsed / 2, steady * elapsed, steady, 0, 0};
  for (std::size_t i = 0; i < angle_.size(); ++i) {
    const auto& [amplitude, frequency, phase] = push_.waves[i];
    if (amplitude == 0) continue;
    const auto [sine, cosine] = angle_[i];
    const long double turned = frequency * elapsed;
    const long double half_sine = std::sin(turned / 2);
    const long double half_cosine = std::cos(turned / 2);
    const long double versine = 2 * half_sine * half_sine;  // 1 - cos(turned)
    const long double turned_sine = 2 * half_sine * half_cosine;
    const long double cosine_now = cosine - (cosine * versine + sine * turned_sine);
    const long double sine_now = sine - (sine * versine - cosine * turned_sine);
    const long double middle_cosine = cosine * half_cosine - sine * half_sine;
    sum.distance += amplitude / (frequency * frequency) * (cosine * versine - sine * lag(turned));
    sum.speed += amplitude / frequency * 2 * middle_cosine * half_sine;
    sum.acceleration += amplitude * cosine_now;
    sum.jerk -= amplitude * frequency * sine_now;
    sum.snap -= amplitude * frequency * frequency * cosine_now;
  }
  return sum;
}

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
