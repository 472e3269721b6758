#include "src/core/csv_field.h"

#include <system_error>

#include "src/core/number_of_text.h"

namespace ricochet {
namespace {

bool looks_like_a_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text[0]) != std::string_view::npos &&
         !number_of_text<double>(text);
}

}  // namespace

std::string csv_field(std::string_view text) {
  std::string field(looks_like_a_formula(text) ? "'" : "");
  field += text;
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace ricochet
