#include "src/report/column_labels.h"

#include <fmt/format.h>

namespace ricochet::report {
namespace {

constexpr std::size_t most_that_fit = 3;

std::string css_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace

std::string column_labels(const std::vector<std::string>& titles) {
  std::string style;
  if (titles.size() <= most_that_fit) return style;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    style += fmt::format("--{}:{};", i + 1, css_text(titles[i]));
  }
  return style;
}

}  // namespace ricochet::report
