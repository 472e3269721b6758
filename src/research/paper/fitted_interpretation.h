#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "src/research/paper/unknown_parameters.h"

namespace ricochet::carrier_track::inline paper {

/// An interpretation of the paper with values for all its unknown parameters, and their origin.
struct FittedInterpretation {
  Interpretation interpretation;
  Constants constants;
  std::vector<Unknown> free;  ///< the parameters that were fitted; the others are natural
  std::string provenance;     ///< in a sentence
  std::string name;           ///< name_of(interpretation)
  std::string description;    ///< description_of(interpretation)
  Scene scene;                ///< of every case, but for restitution, friction and disturbance
};

/// The file text: TOML with the interpretation, its parameters in SI units, which of them are
/// fitted, and the provenance.
std::string write_fitted_interpretation(const FittedInterpretation& fitted);

/// Throws InputError if the text is invalid, if parameters lie outside their bounds, or if the
/// interpretation needs more than a scene: a crossing, or a case's numbers in other units.
FittedInterpretation parse_fitted_interpretation(const std::string& text,
                                                 const std::string& origin);

/// Puts the parts together. Throws InputError as above.
FittedInterpretation fitted_interpretation(const Interpretation& interpretation,
                                           const Constants& constants, std::vector<Unknown> free,
                                           std::string provenance, const std::string& origin);

/// Returns true if the scenes of all cases differ only in restitution, friction and disturbance.
bool is_one_scene(const Interpretation& interpretation);

/// The interpretation that every command uses: interpretation.toml, which `ricochet calibrate`
/// regenerates.
const FittedInterpretation& default_interpretation();

}  // namespace ricochet::carrier_track::inline paper
