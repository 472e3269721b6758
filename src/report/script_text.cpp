#include "src/report/script_text.h"

#include <fmt/format.h>

namespace ricochet::report {

std::string json_in_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string data_script(const char* name, const Json& data) {
  return fmt::format("<script type=\"application/json\" class=\"{}\">{}</script>", name,
                     json_in_script(data.dump()));
}

}  // namespace ricochet::report
