#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "problems/carrier_track/impact_model.h"

namespace ricochet::carrier_track {

struct Impact {
  double time;  ///< [s]
  Wall wall;
  double speed;  ///< [m/s], approach speed
};

struct Peak {
  double time;      ///< [s]
  double position;  ///< [m]
};

struct Sample {
  double time;      ///< [s]
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// One simulation with all that there is to say of it.
struct Recording {
  int count = 0;
  double surrogate = 0;
  bool certain = false;          ///< see is_certain
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::vector<Impact> impacts;
  std::vector<Peak> peaks;
  std::vector<Sample> path;
  End<double> end{};
};

/// Simulates a valid scene and keeps everything. The path is sampled at the ends of every stretch,
/// at every step in a compliant wall, and evenly in between, about `samples` times over the window;
/// 0 keeps no path.
Recording record(const Scene& scene, double width, std::size_t samples);

/// Whether the count of a valid scene stays the same when mass and restitution are changed by one
/// part in 1e9, up and down: about a million times what rounding does. An uncertain count is not
/// wrong, but its path is so sensitive, or a feature so near its limit, that nobody can tell.
bool is_certain(const Scene& scene, int count);

}  // namespace ricochet::carrier_track
