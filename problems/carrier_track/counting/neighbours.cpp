#include "problems/carrier_track/counting/neighbours.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "problems/carrier_track/scene/perturbation.h"
#include "ricochet/recording.h"
#include "ricochet/time_limit.h"

namespace ricochet::carrier_track::inline counting {
namespace {

// Strides: the fractional parts of the golden ratio and of the square root of two.
constexpr double golden_stride = 0.6180339887498949;
constexpr double root_stride = 0.4142135623730950;

bool crosses(const Scene& scene) {
  return !(scene.wall_upper > scene.wall_lower) ||
         (scene.across && !(scene.across->wall_upper > scene.across->wall_lower));
}

}  // namespace

Neighbour::Neighbour(const Scene& given, double stride, double sign)
    : scene(perturbed(given, stride, sign)), end(duration_of(scene)), trace(scene) {
  std::visit([](auto& window) { window.count *= 1 + same_time; }, scene.window);
}

void Neighbour::end_with(const End<double>& last, std::exception_ptr thrown) {
  failure = std::move(thrown);
  if (!failure && (!trace.finite() || !std::isfinite(last.position + last.velocity))) {
    failure = std::make_exception_ptr(std::runtime_error("numbers overflow"));
  }
}

Neighbours::Neighbours(const Scene& scene)
    : all_{{{scene, golden_stride, +1},
            {scene, golden_stride, -1},
            {scene, root_stride, +1},
            {scene, root_stride, -1}}} {}

Neighbours::Side Neighbours::one_side() {
  simulate_side(0);
  return {&all_[0], &all_[2]};
}

const std::array<Neighbour, 4>& Neighbours::all() {
  simulate_side(0);
  if (!all_[0].failure) simulate_side(1);
  return all_;
}

void Neighbours::simulate_side(std::size_t side) {
  if (std::exchange(simulated_[side], true)) return;
  for (Neighbour* n : sound_ones(side)) {
    try {
      n->end_with(simulate(n->scene, n->trace), nullptr);
    } catch (const TimeLimitReached&) {
      throw;
    } catch (...) {
      n->failure = std::current_exception();
    }
    if (n->failure) break;
  }
}

std::vector<Neighbour*> Neighbours::sound_ones(std::size_t side) {
  std::vector<Neighbour*> sound;
  for (const std::size_t k : {side, side + 2}) {
    Neighbour& n = all_[k];
    if (crosses(n.scene)) {
      n.failure = std::make_exception_ptr(std::runtime_error("one wall crosses the other"));
    } else {
      sound.push_back(&n);
    }
  }
  return sound;
}

}  // namespace ricochet::carrier_track::inline counting
