#include "problems/carrier_track/check/oracle/push.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

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

}  // namespace ricochet::carrier_track::inline oracle
