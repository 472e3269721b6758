#pragma once

#include <string>

#include "src/campaign/campaign.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// Runs that are made at once.
int cores();

/// Seconds in the unit that people would say it in.
std::string duration(double seconds);

/// What a campaign runs, in numbers.
report::Json size_of(const Campaign& campaign);

/// The same for people.
std::string in_words(const report::Json& size);

}  // namespace ricochet::cli
