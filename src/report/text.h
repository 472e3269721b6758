#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

namespace ricochet::report {

/// The text as content of an HTML or XML element, or of a quoted attribute. Control characters,
/// which XML forbids, become spaces.
std::string escape_html(std::string_view text);

/// The text as inline Markdown that reads as the text itself, also in a table's cell.
std::string escape_markdown(std::string_view text);

/// As escape_html, with every https:// address made a link.
std::string html_with_links(std::string_view text);

/// The value in fmt's `form`, such as "{:.2f}", or a dash where there is none.
template <class T>
std::string text_or_dash(const std::optional<T>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "–";
}

}  // namespace ricochet::report
