#include "problems/families.h"

#include "problems/carrier_track/questions/families.h"
#include "problems/classic/families.h"

namespace ricochet {

std::vector<Family> all_families() {
  std::vector<Family> families = carrier_track::case_families();
  for (Family& family : classic::families()) families.push_back(std::move(family));
  return families;
}

}  // namespace ricochet
