#pragma once

#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// Published results of others, from published.json, by the name of the comparison; each with its
/// `source`.
const report::Json& published();

}  // namespace ricochet::studies::fireworks
