#pragma once

#include <ricochet/ricochet.h>

#include <string>
#include <utility>
#include <vector>

#include "ricochet/recording.h"
#include "ricochet/regimes.h"
#include "ricochet/scene.h"

/// The handle of an open machine.
struct ricochet_machine {};

namespace ricochet::interface {

/// A machine opened by an external program, and the results of its last calls.
struct OpenedMachine : ricochet_machine {
  /// Errors name the text `origin`. Throws InputError if it is no valid machine.
  OpenedMachine(std::string machine_text, const std::string& origin)
      : text(std::move(machine_text)), scene(carrier_track::parse_scene(text, origin)) {}

  std::string text;  ///< of its file
  carrier_track::Scene scene;
  carrier_track::Recording recording;  ///< of the last simulation
  std::vector<carrier_track::Regime> regimes;
  std::vector<std::string> regime_ends;  ///< names, one for each regime
};

}  // namespace ricochet::interface
