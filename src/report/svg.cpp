#include "src/report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "src/report/script.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

bool is_tag(std::string_view token) {
  return token.starts_with('<');
}

bool opens(std::string_view token, std::string_view name) {
  return token.starts_with('<') && token.substr(1).starts_with(name) &&
         token.substr(1 + name.size()).find_first_of(" \n\t/>") == 0;
}

/// Tags and the text between them, without white space that only indents. No label can be mistaken
/// for a tag: gnuplot escapes its '<'.
std::vector<std::string> tokens(std::string_view svg) {
  std::vector<std::string> result;
  while (!svg.empty()) {
    std::size_t end = is_tag(svg) ? svg.find('>') : svg.find('<');
    end = end == std::string_view::npos ? svg.size() : end + (is_tag(svg) ? 1 : 0);
    const std::string_view token = svg.substr(0, end);
    if (token.find_first_not_of(" \t\r\n") != std::string_view::npos) result.emplace_back(token);
    svg.remove_prefix(end);
  }
  return result;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// The value of the attribute, "" if the tag has none; gnuplot uses both kinds of quotes.
std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t at = tag.find(" " + name + "=");
  if (at == std::string::npos) return "";
  const std::size_t quote = at + name.size() + 2;
  return tag.substr(quote + 1, tag.find(tag[quote], quote + 1) - quote - 1);
}

/// Drops groups without content and the elements from <name> to </name>.
std::vector<std::string> without_ballast(const std::vector<std::string>& all) {
  std::vector<std::string> kept;
  bool inside_filter = false, inside_series_title = false;
  bool document_title = true;
  for (const std::string& token : all) {
    if (opens(token, "filter")) inside_filter = true;
    // gnuplot titles every plot, some of them with nothing but a number.
    if (opens(token, "title") && !document_title) inside_series_title = true;
    const bool drop = inside_filter || inside_series_title || token.starts_with("<?xml") ||
                      opens(token, "tspan") || token == "</tspan>";
    if (token == "</filter>") inside_filter = false;
    if (token == "</title>") inside_series_title = document_title = false;
    if (drop) continue;
    if (token == "</g>" && !kept.empty() && opens(kept.back(), "g"))
      kept.pop_back();
    else
      kept.push_back(token);
  }
  return kept;
}

/// Drops the markers that nothing uses. From the end, because their uses come after them.
void drop_unused_markers(std::vector<std::string>& all) {
  std::set<std::string> used;
  for (std::size_t i = all.size(); i-- > 0;) {
    const std::string id = attribute(all[i], "id");
    if (id.starts_with("gp") && all[i].ends_with("/>") && !used.contains(id)) {
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
      continue;
    }
    const std::string target = attribute(all[i], "xlink:href");
    if (target.starts_with('#')) used.insert(target.substr(1));
  }
}

}  // namespace

std::string finish_svg(const std::string& svg, const std::string& name, const std::string& title,
                       const std::string& description) {
  std::vector<std::string> all = without_ballast(tokens(svg));
  drop_unused_markers(all);
  std::string result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::string& token = all[i];
    if (!is_tag(token)) {
      if (i > 0 && opens(all[i - 1], "title")) token = escape_html(title);
      if (i > 0 && opens(all[i - 1], "desc")) token = escape_html(description);
      result += token;
      continue;
    }
    replace_all(token, "id='", "id='" + name + "-");
    replace_all(token, "id=\"", "id=\"" + name + "-");
    replace_all(token, "href='#", "href='#" + name + "-");
    replace_all(token, "url(#", "url(#" + name + "-");
    replace_all(token, fmt::format(" font-family=\"{}\"", body_font), "");
    replace_all(token, fmt::format(" font-family=\"{}\"", title_font), " font-weight=\"600\"");
    if (opens(token, "svg"))
      token = fmt::format(
          "{} role=\"img\" aria-labelledby=\"{}-title {}-desc\" font-family=\"system-ui, 'Segoe "
          "UI', Roboto, 'Helvetica Neue', Arial, sans-serif\"{}",
          svg_start, name, name, token.substr(4));
    if (token == "<title>") token = fmt::format("<title id=\"{}-title\">", name);
    if (token == "<desc>") token = fmt::format("<desc id=\"{}-desc\">", name);
    result += token;
    if (!opens(token, "text") && !opens(token, "title") && !opens(token, "desc")) result += '\n';
  }
  return result;
}

}  // namespace ricochet::report
