#pragma once

#include <toml++/toml.h>

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

/// Changes one key of a scene's file, or adds it. A setting is KEY=VALUE, e.g. "friction=0.3",
/// "wall_upper=0.9 mm", "window.revolutions=3" or "model.fidelity=planar". The table may be left
/// out if the file has the key in one place only; the keys of [across] count if the file has that
/// table. A value is written as in a file; the quotes of a text may be left out. Keys that say the
/// same in other words, such as window.seconds for window.revolutions, are removed.
///
/// Throws InputError, which names the setting, for one without "=", or an unknown or ambiguous key.
/// The value is checked when the file is read.
void apply_setting(toml::table& file, const std::string& setting);

}  // namespace ricochet::carrier_track::inline scene
