#include <string>

#include "ricochet/regimes.h"

namespace ricochet::carrier_track::inline regimes {

std::string name_of(RegimeEnd end) {
  switch (end) {
    case RegimeEnd::release:
      return "release";
    case RegimeEnd::counting_limit:
      return "counting-limit";
    case RegimeEnd::grazing:
      return "grazing";
    case RegimeEnd::end_of_rest:
      return "end-of-rest";
    case RegimeEnd::start_of_rest:
      return "start-of-rest";
    case RegimeEnd::flip:
      return "flip";
    case RegimeEnd::fold:
      return "fold";
    case RegimeEnd::irregular:
      return "irregular";
    case RegimeEnd::range:
      return "range";
    case RegimeEnd::time_limit:
      return "time-limit";
  }
  return "";
}

}  // namespace ricochet::carrier_track::inline regimes
