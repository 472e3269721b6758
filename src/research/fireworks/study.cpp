#include "src/research/fireworks/study.h"

#include "src/research/fireworks/competition.h"
#include "src/research/fireworks/plateau.h"
#include "src/research/fireworks/shift.h"
#include "src/research/fireworks/table_3.h"

namespace ricochet::studies {
namespace {

report::Json compute(bool quick) {
  using namespace fireworks;
  return {{"table_3", table_3_data(quick ? 5 : 20)},
          {"shift", shift_data(quick ? 5 : 20)},
          {"competition", competition_data(quick ? 2 : 15, 300'000)},
          {"plateau", plateau_data(quick ? 100 : 1000)}};
}

}  // namespace

Study fireworks_study() {
  return {"fireworks", "Fewer runs, in a minute", compute};
}

}  // namespace ricochet::studies
