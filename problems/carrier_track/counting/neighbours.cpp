#include "problems/carrier_track/counting/neighbours.h"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "problems/carrier_track/scene/perturbation.h"
#include "ricochet/recording.h"

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

const std::array<Neighbour, 4>& Neighbours::simulated() {
  if (simulated_) return all_;
  simulated_ = true;
  for (Neighbour* n : sound_ones()) {
    try {
      n->end_with(simulate(n->scene, n->trace), nullptr);
    } catch (...) {
      n->failure = std::current_exception();
    }
    if (n->failure) break;
  }
  return all_;
}

std::vector<Neighbour*> Neighbours::sound_ones() {
  std::vector<Neighbour*> sound;
  for (Neighbour& n : all_) {
    if (crosses(n.scene)) {
      n.failure = std::make_exception_ptr(std::runtime_error("one wall crosses the other"));
    } else {
      sound.push_back(&n);
    }
  }
  return sound;
}

}  // namespace ricochet::carrier_track::inline counting
