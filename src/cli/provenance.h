#pragma once

#include "src/benchmark/experiment/campaign/stored_campaign.h"

namespace ricochet::cli {

/// Returns what stores written by this program record about their origin.
Provenance provenance();

}  // namespace ricochet::cli
