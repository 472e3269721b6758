#include "src/research/fireworks/published.h"

#include "embedded/published.h"

namespace ricochet::studies::fireworks {

const report::Json& published() {
  static const report::Json all = report::Json::parse(embedded::published);
  return all;
}

}  // namespace ricochet::studies::fireworks
