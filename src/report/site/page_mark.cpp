#include "src/report/site/page_mark.h"

#include <fstream>
#include <iterator>

#include "src/core/text_file.h"

namespace ricochet::site {

void put_at(const std::filesystem::path& page, const std::string& mark, const std::string& html) {
  // In reports/templates/page.mustache.
  const std::string opening = "<!-- " + mark + " -->", closing = "<!-- /" + mark + " -->";
  std::ifstream stream(page, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::size_t start = text.find(opening), end = text.find(closing);
  if (start == std::string::npos || end == std::string::npos || end < start) return;
  const std::size_t after = start + opening.size();
  const std::string changed = text.substr(0, after) + "\n" + html + text.substr(end);
  if (changed != text) write_text_file(page, changed);
}

}  // namespace ricochet::site
