#include "problems/families.h"

#include "problems/carrier_track/families.h"

namespace ricochet {

std::vector<Family> all_families() {
  return carrier_track::case_families();
}

}  // namespace ricochet
