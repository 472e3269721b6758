#pragma once

#include <string>

#include "src/benchmark/experiment/campaign/campaign.h"
#include "src/benchmark/experiment/campaign/forecast.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// Seconds as text in a suitable unit.
std::string duration(double seconds);

/// Counts what a campaign runs.
report::Json size_of(const Campaign& campaign);

/// The same as text.
std::string in_words(const report::Json& size);

/// A forecast as text: the elapsed time on so many cores.
std::string in_words(const Forecast& forecast, int cores);

}  // namespace ricochet::cli
