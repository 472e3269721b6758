#pragma once

#include <filesystem>
#include <string>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline scene {

/// Reads a machine from a TOML file with the tables [scene], [across], [window], [count] and
/// [model] of the README. Throws InputError, in one line with file, key, value and what is allowed,
/// for a file that cannot be read or parsed, an unknown or missing key, a wrong type, or a value
/// out of range.
Scene read_scene(const std::filesystem::path& path);

/// The same from a text. Errors name it `origin`.
Scene parse_scene(const std::string& text, const std::string& origin);

/// The scene as a TOML text that read_scene reads back to the same scene, bit for bit.
std::string write_scene(const Scene& scene);

}  // namespace ricochet::carrier_track::inline scene
