#include "src/live/count_there.h"

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/motion/impact_model.h"

namespace ricochet::live {

using namespace carrier_track;

int count_there(const Scene& scene) {
  if (!suits_lanes(scene)) return static_cast<int>(objective(scene, 0.0));
  ImpactCount impacts;
  impacts.counting_limit = scene.counting_limit;
  ImpactModel<double>(scene).run(impacts);
  return impacts.count;
}

}  // namespace ricochet::live
