#include "src/report/script_text.h"

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

}  // namespace ricochet::report
