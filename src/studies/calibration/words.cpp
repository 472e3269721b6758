#include <algorithm>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {

std::string words_of(carrier_track::Open constant) {
  std::string words(carrier_track::open_constants()[static_cast<std::size_t>(constant)].name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace ricochet::studies::calibration
