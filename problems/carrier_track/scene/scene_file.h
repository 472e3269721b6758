#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// A number of a file that is given as {value = ..., plus_minus = ...}: it is taken as uniformly
/// distributed within value - plus_minus .. value + plus_minus.
struct Uncertainty {
  std::string key;    ///< with its table, e.g. "scene.friction"
  double value;       ///< [unit]
  double plus_minus;  ///< [unit], half the width of the distribution, > 0
  std::string unit;   ///< "1" for a number without a unit
};

/// What a scene's file says: the scene, and how uncertain its numbers are.
struct SceneFile {
  Scene scene;  ///< at the values
  std::vector<Uncertainty> uncertainties;

  /// The scene with every uncertain number at value + share * plus_minus, one share within -1..1
  /// for each, in their order. What the file says about the numbers together still holds: with
  /// path_radius, centrifugal_mass_radius follows the mass. Throws InputError if several numbers at
  /// their ends make no valid scene; one alone does.
  std::function<Scene(std::span<const double> shares)> at;
};

/// Reads a file as read_scene() does; "-" is standard input. Each of `settings`, such as
/// "friction=0.3", is applied to the file before it is read, see apply_setting(). Throws
/// InputError, which names the settings, too.
SceneFile read_scene_file(const std::string& path, const std::vector<std::string>& settings = {});

/// The same from a text. Errors name it `origin`.
SceneFile parse_scene_file(const std::string& text, const std::string& origin,
                           const std::vector<std::string>& settings = {});

}  // namespace ricochet::carrier_track::inline scene
