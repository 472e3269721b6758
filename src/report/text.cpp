#include "src/report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ricochet::report {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += is_control(c) ? ' ' : c;
    }
  }
  return escaped;
}

std::string escape_markdown(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    // A bracket is only special if a link's target can follow; units in brackets are not escaped.
    const bool before_target = c == ']' && i + 1 < text.size() &&
                               std::string_view("([:").find(text[i + 1]) != std::string_view::npos;
    // An underscore inside a word is not emphasis, and a name is more readable without the
    // backslash.
    const bool inside_word =
        i > 0 && i + 1 < text.size() && is_word(text[i - 1]) && is_word(text[i + 1]);
    if (c == '<') {
      escaped += "&lt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else if (is_control(c)) {
      escaped += ' ';
    } else {
      if (std::string_view("\\|*`").find(c) != std::string_view::npos ||
          (c == '_' && !inside_word) || before_target)
        escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string html_with_links(std::string_view text) {
  std::string html;
  while (true) {
    const std::size_t start = text.find("https://");
    html += escape_html(text.substr(0, start));
    if (start == std::string_view::npos) return html;
    text.remove_prefix(start);
    std::size_t end = std::min(text.find_first_of(" \t\n<>\"'"), text.size());
    // Punctuation at the end of the sentence is not part of the address.
    while (std::string_view(".,;:)").find(text[end - 1]) != std::string_view::npos) --end;
    const std::string address = escape_html(text.substr(0, end));
    html += fmt::format("<a href=\"{0}\">{0}</a>", address);
    text.remove_prefix(end);
  }
}

}  // namespace ricochet::report
