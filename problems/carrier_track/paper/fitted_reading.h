#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "problems/carrier_track/paper/open_constants.h"

namespace ricochet::carrier_track::inline paper {

/// A reading of the paper with a value for each of its open constants, and where they come from.
struct FittedReading {
  Reading reading;
  Constants constants;
  std::vector<Open> freed;  ///< the constants that were fitted; the others are natural
  std::string provenance;   ///< in a sentence
  std::string name;         ///< name_of(reading)
  std::string description;  ///< description_of(reading)
  Scene scene;              ///< of every case, but for restitution, friction and disturbance
};

/// The file text: TOML with the reading, its constants in SI units, which of them are fitted, and
/// the provenance.
std::string write_fitted_reading(const FittedReading& fitted);

/// Throws InputError for a text that is none, whose constants lie outside their bounds, or whose
/// reading needs more than a scene: a crossing, or a case's numbers in other units.
FittedReading parse_fitted_reading(const std::string& text, const std::string& origin);

/// Puts the parts together. Throws InputError as above.
FittedReading fitted_reading(const Reading& reading, const Constants& constants,
                             std::vector<Open> freed, std::string provenance,
                             const std::string& origin);

/// Whether the scene of every case is one scene but for restitution, friction and disturbance.
bool is_one_scene(const Reading& reading);

/// The reading that every command uses: reading.toml, which `ricochet calibrate` regenerates.
const FittedReading& default_reading();

}  // namespace ricochet::carrier_track::inline paper
