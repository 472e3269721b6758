#include "src/core/label.h"

#include <algorithm>
#include <array>

namespace ricochet {
namespace {

/// What pandas 2.2 takes for missing by default, except the empty text and "nan"; R: "NA".
constexpr std::array<std::string_view, 17> read_as_missing = {
    "#N/A", "#N/A N/A", "#NA", "-1.#IND", "-1.#QNAN", "-NaN", "-nan", "1.#IND", "1.#QNAN",
    "<NA>", "N/A",      "NA",  "NULL",    "NaN",      "None", "n/a",  "null"};

}  // namespace

std::string label(std::string_view text) {
  if (text == "nan") return "missing-value";
  const bool swallowed = std::ranges::find(read_as_missing, text) != read_as_missing.end();
  std::string label(swallowed ? "'" : "");
  return label += text;
}

}  // namespace ricochet
