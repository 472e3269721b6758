#include "src/research/impact_test/test_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/scene/window.h"

namespace ricochet::studies::impact_test {
namespace {

using namespace carrier_track;

using Real = long double;
using Polynomial = std::array<Real, 3>;

constexpr Real pi = std::numbers::pi_v<Real>;

/// The driver plate from a time on: alpha + omega u + slope u^2 / 2.
struct Leg {
  Real from, alpha, omega, slope;
};

std::vector<Leg> legs_of(const Scene& machine) {
  const Real phase = machine.phase;
  if (machine.profile.empty()) return {{0, phase, machine.omega, 0}};
  std::vector<Leg> legs = {{0, phase, machine.profile.front().omega, 0}};
  for (std::size_t k = 0; k < machine.profile.size(); ++k) {
    const auto& [time, omega] = machine.profile[k];
    const Leg& last = legs.back();
    const Real since = time - last.from;
    Leg leg{time, last.alpha + since * (last.omega + last.slope * since / 2), omega, 0};
    if (k + 1 < machine.profile.size()) {
      const auto& next = machine.profile[k + 1];
      leg.slope = (static_cast<Real>(next.omega) - omega) / (static_cast<Real>(next.time) - time);
    }
    if (since > 0) {
      legs.push_back(leg);
    } else {
      legs.back() = leg;
    }
  }
  for (Leg& leg : legs) leg.alpha = std::remainder(leg.alpha, 2 * pi);
  return legs;
}

std::array<double, 3> rounded(const Polynomial& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

/// Collects the terms of a segment, without those that are zero.
class Terms {
 public:
  void add(const Polynomial& amplitude, const Polynomial& phase) {
    const auto a = rounded(amplitude);
    if (std::ranges::all_of(a, [](double x) { return x == 0; })) return;
    terms_.push_back({a, rounded(phase)});
  }
  std::vector<ForceTerm> take() { return std::move(terms_); }

 private:
  std::vector<ForceTerm> terms_;
};

ForceSegment segment_of(const Scene& machine, const Leg& leg) {
  const Polynomial square = {leg.omega * leg.omega, 2 * leg.omega * leg.slope,
                             leg.slope * leg.slope};
  const auto times = [](Real factor, Polynomial p) {
    for (Real& x : p) x *= factor;
    return p;
  };
  const auto turned = [&](Real by) { return Polynomial{leg.alpha + by, leg.omega, leg.slope / 2}; };
  Polynomial steady = {};
  Real plate = -static_cast<Real>(machine.slider_mass_radius);
  const Real centrifugal = machine.centrifugal_mass_radius;
  if (machine.centrifugal == Centrifugal::projected) plate += centrifugal;
  if (machine.centrifugal == Centrifugal::inward) steady = times(-centrifugal, square);
  if (machine.centrifugal == Centrifugal::outward) steady = times(centrifugal, square);
  if (!machine.pull_rotates) steady[0] -= machine.pull;
  Terms terms;
  terms.add(steady, {});
  terms.add(times(plate, square), turned(0));
  // -omega' sin alpha = -omega' cos(alpha - pi / 2)
  terms.add({-machine.slider_mass_radius * leg.slope, 0, 0}, turned(-pi / 2));
  if (machine.pull_rotates) terms.add({-machine.pull, 0, 0}, turned(machine.pull_phase));
  const Real frequency = machine.disturbance_frequency;
  terms.add(
      {machine.disturbance, 0, 0},
      {std::remainder(machine.disturbance_phase + frequency * leg.from, 2 * pi), frequency, 0});
  return {static_cast<double>(leg.from), terms.take()};
}

double polynomial(const std::array<double, 3>& p, double u) {
  return p[0] + u * (p[1] + u * p[2]);
}

}  // namespace

TestScene test_scene(const Scene& machine) {
  TestScene scene;
  scene.mass = machine.mass;
  scene.lower = machine.wall_lower;
  if (std::isfinite(machine.wall_upper)) scene.upper = machine.wall_upper;
  scene.restitution_lower = machine.restitution_lower;
  scene.restitution_upper = machine.restitution_upper;
  scene.friction = machine.friction * machine.normal_force;
  scene.position = machine.start_position;
  scene.velocity = machine.start_velocity;
  scene.duration = duration_of(machine);
  scene.slowest = machine.counting_limit;
  for (const Leg& leg : legs_of(machine)) {
    if (leg.from < scene.duration) scene.force.push_back(segment_of(machine, leg));
  }
  return scene;
}

double force_at(const TestScene& scene, double time) {
  const auto next = std::upper_bound(scene.force.begin(), scene.force.end(), time,
                                     [](double t, const ForceSegment& s) { return t < s.from; });
  const ForceSegment& segment = *(next - 1);
  double sum = 0;
  for (const ForceTerm& term : segment.terms) {
    const double u = time - segment.from;
    sum += polynomial(term.amplitude, u) * std::cos(polynomial(term.phase, u));
  }
  return sum;
}

}  // namespace ricochet::studies::impact_test
