#include "src/report/site/page_mark.h"

#include <system_error>

#include "src/core/text_file.h"

namespace ricochet::site {

void put_at(const std::filesystem::path& page, const std::string& mark, const std::string& html) {
  // In reports/templates/page.mustache.
  const std::string opening = "<!-- " + mark + " -->", closing = "<!-- /" + mark + " -->";
  std::error_code none;
  if (!std::filesystem::exists(page, none)) return;
  const std::string text = text_of_file(page);
  const std::size_t start = text.find(opening), end = text.find(closing);
  if (start == std::string::npos || end == std::string::npos || end < start) return;
  const std::size_t after = start + opening.size();
  const std::string changed = text.substr(0, after) + "\n" + html + text.substr(end);
  if (changed != text) write_text_file(page, changed, SymbolicLinks::refused);
}

}  // namespace ricochet::site
