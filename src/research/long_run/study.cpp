#include "src/research/long_run/study.h"

#include "src/research/long_run/results.h"

namespace ricochet::studies {

Study long_run_study() {
  const auto compute = [](bool quick) {
    return long_run::data_of(
        long_run::long_run(quick ? long_run::quick_plan() : long_run::full_plan()));
  };
  return {"long-run", "A first look, in half a minute: nothing converges", compute};
}

}  // namespace ricochet::studies
