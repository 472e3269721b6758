#include "solvers/fireworks/fireworks_family.h"

#include "solvers/fireworks/bare_bones_fireworks.h"
#include "solvers/fireworks/dynamic_fireworks.h"
#include "solvers/fireworks/fireworks.h"
#include "solvers/fireworks/loser_out_fireworks.h"
#include "solvers/fireworks/partitioned_fireworks.h"

namespace ricochet::fireworks {

std::vector<Solver> family() {
  FireworksOptions as_printed = paper_options();
  as_printed.counts.third_branch = ThirdBranch::as_printed;
  return {fireworks("fireworks", paper_options()),
          fireworks("fireworks-as-printed", as_printed),
          fireworks("fireworks-authors", authors_options()),
          fireworks("fireworks-corrected", corrected_options()),
          fireworks("efwa", enhanced_options()),
          dynamic_fireworks("dynfwa"),
          bare_bones_fireworks("bbfwa"),
          loser_out_fireworks("lotfwa"),
          loser_out_fireworks("mgfwa", multi_guiding_options()),
          partitioned_fireworks("fwassp")};
}

}  // namespace ricochet::fireworks
