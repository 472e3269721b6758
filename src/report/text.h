#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

namespace ricochet::report {

/// Escapes text as content of an HTML or XML element or of a quoted attribute. Control characters,
/// which XML forbids, become spaces.
std::string escape_html(std::string_view text);

/// Escapes text as inline Markdown, also for a table's cell.
std::string escape_markdown(std::string_view text);

/// Like escape_html, and turns every https:// address into a link.
std::string html_with_links(std::string_view text);

/// Formats the value with fmt's `form`, such as "{:.2f}"; a dash if it is missing.
template <class T>
std::string text_or_dash(const std::optional<T>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "–";
}

}  // namespace ricochet::report
