#pragma once

#include <fmt/format.h>

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// The agreement of two orders in words; null if they cannot be compared.
inline std::string agreement_in_words(const report::Json& agreement) {
  if (agreement.is_null()) return "the orders cannot be compared";
  return fmt::format("Kendall's tau {:.2f} [{:.2f}, {:.2f}] over {} entries",
                     agreement["correlation"].get<double>(), agreement["lower"].get<double>(),
                     agreement["upper"].get<double>(), agreement["entries"].get<int>());
}

}  // namespace ricochet::cli
