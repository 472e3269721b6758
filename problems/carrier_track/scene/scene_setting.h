#pragma once

#include <toml++/toml.h>

#include <string>

namespace ricochet::carrier_track::inline scene {

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
