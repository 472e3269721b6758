#include "src/report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <deque>
#include <kainjow/mustache.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <unordered_map>

#include "src/report/frame.h"
#include "src/report/page_template.h"

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
  static constexpr const char* entities[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string escaped;
  for (const char c : text) {
    const std::size_t special = std::string_view("&<>\"'").find(c);
    if (special != std::string_view::npos) {
      escaped += entities[special];
    } else {
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

std::string counted(std::int64_t number, std::string_view noun, std::string_view plural) {
  if (number != 1 && !plural.empty()) return fmt::format("{} {}", number, plural);
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string seconds_text(double seconds, int digits) {
  const auto [factor, unit] = seconds < 1e-3 ? std::pair{1e6, "µs"}
                              : seconds < 1  ? std::pair{1e3, "ms"}
                                             : std::pair{1.0, "s"};
  return fmt::format("{:.{}g} {}", factor * seconds, digits, unit);
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

namespace {

bool starts_character(char c) {
  return (c & 0xc0) != 0x80;  // of UTF-8
}

}  // namespace

double text_width(const std::string& text, double size) {
  // Fortieths of the size, from the character '0' on, of the printable characters of ASCII.
  static constexpr std::string_view widths =
      "=@BRIVO;@@DR=>==IIIIIIIIII==RRREXKKLOIGON<<JFSNOHOLIHMKXKHK@=@RDDIIFII>II;;G;WIHII@E@"
      "IHQHHEI=IR";
  double width = 0;
  for (const char c : text) {
    const auto place = static_cast<std::size_t>(static_cast<unsigned char>(c) - ' ');
    if (starts_character(c)) width += place < widths.size() ? widths[place] - '0' : 26;
  }
  return width * size / 40;
}

double widest(const std::vector<std::string>& texts, double size) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(text, size));
  return width;
}

std::string shortened(const std::string& text, double room, double size) {
  if (text_width(text, size) <= room) return text;
  std::string kept = text;
  while (!kept.empty() && text_width(kept + "…", size) > room) {
    while (kept.size() > 1 && !starts_character(kept.back())) kept.pop_back();
    kept.pop_back();
  }
  return kept + "…";
}

std::vector<std::string> wrapped(const std::string& text, double room, double size) {
  if (!text.empty() && text_width(text, size) <= room) return {text};
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.empty() && text_width(lines.back() + " " + word, size) <= room) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

namespace {

std::string in_page_of(const std::string& place) {
  const std::size_t hash = place.find('#');
  if (hash == std::string::npos) throw std::invalid_argument("a cell's link has no #: " + place);
  return place.substr(0, hash) + "/index.html" + place.substr(hash);
}

}  // namespace

Json cell_links_data(const Chart& chart, const CellLinks& links) {
  if (links.rows.size() != chart.y.categories.size() ||
      links.columns.size() != chart.x.categories.size()) {
    throw std::invalid_argument("chart \"" + chart.name + "\": not a link for each row and column");
  }
  const Box box = frame_of(chart).plot;
  Json rows = Json::array(), columns = Json::array();
  for (std::size_t row = links.rows.size(); row-- > 0;) {
    rows.push_back({chart.y.categories[row], in_page_of(links.rows[row])});
  }
  for (std::size_t column = 0; column < links.columns.size(); ++column) {
    columns.push_back({chart.x.categories[column], links.columns[column]});
  }
  return {{"box", {box.left, box.right, box.top, box.bottom}},
          {"rows", std::move(rows)},
          {"columns", std::move(columns)}};
}

std::string with_slots(std::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t start; (start = text.find("{{")) != std::string_view::npos;) {
    const std::size_t end = text.find("}}", start);
    result += text.substr(0, start);
    result += values.at(std::string(text.substr(start + 2, end - start - 2)));
    text.remove_prefix(end + 2);
  }
  return result += text;
}

namespace {

namespace mustache = kainjow::mustache;

const Json* looked_up(const Json& scope, const std::string& name) {
  const Json* data = &scope;
  std::size_t start = 0;
  while (start <= name.size()) {
    const std::size_t end = std::min(name.find('.', start), name.size());
    if (!data->is_object()) return nullptr;
    const auto found = data->find(name.substr(start, end - start));
    if (found == data->end()) return nullptr;
    data = &*found;
    start = end + 1;
  }
  return data;
}

std::string formatted(const Json& data, std::string formulation, const std::string& name) {
  if (data.is_null()) return "–";
  double scale = 1;
  if (formulation.ends_with('%')) {
    scale = 100;
    formulation.back() = 'f';
  }
  formulation = "{:" + formulation + "}";
  // An integer in the data may be a number with a zero fraction: the format decides.
  const bool fraction = formulation.find_first_of("eEfFgG.") != std::string::npos;
  try {
    if (data.is_string()) return fmt::format(fmt::runtime(formulation), data.get<std::string>());
    if (data.is_number_integer() && !fraction) {
      return fmt::format(fmt::runtime(formulation), data.get<std::int64_t>());
    }
    if (data.is_number()) {
      const auto text = [&](double value) { return fmt::format(fmt::runtime(formulation), value); };
      const std::string exact = text(scale * data.get<double>());
      return exact == text(-0.0) ? text(0.0) : exact;
    }
  } catch (const fmt::format_error& error) {
    throw std::logic_error(
        fmt::format("a template's {} as {}: {}", name, formulation, error.what()));
  }
  throw std::logic_error(fmt::format("a template's {} is neither number nor text", name));
}

/// Answers Mustache's look-ups of names from JSON.
class Context : public mustache::basic_context<std::string> {
 public:
  explicit Context(const Scopes& scopes) : scopes_(scopes) {}

  void push(const mustache::data* node) override {
    const auto found = source_.find(node);
    // A condition without entries adds no scope.
    const bool condition = found == source_.end();
    scopes_.push_back(condition ? scopes_.back() : found->second.data);
    places_.push_back(condition ? places_.back() : found->second.place);
  }
  void pop() override {
    scopes_.pop_back();
    places_.pop_back();
  }

  const mustache::data* get(const std::string& asked) const override {
    if (asked == "@first") return keep(places_.back().first);
    if (asked == "@last") return keep(places_.back().last);
    const std::size_t colon = asked.find(':');
    const std::string name = asked.substr(0, colon);
    const Json& data = found_in(scopes_, name);
    if (colon != std::string::npos) return keep(formatted(data, asked.substr(colon + 1), name));
    if (!is_yes(data)) return keep(false);
    if (data.is_array()) return keep_list(data);
    if (data.is_object()) {
      const mustache::data* node = keep(true);
      source_[node] = {&data, places_.back()};
      return node;
    }
    if (data.is_boolean()) return keep(true);
    return keep(formatted(data, "", name));
  }

  const mustache::data* get_partial(const std::string& /*name*/) const override { return nullptr; }

 private:
  template <class Value>
  const mustache::data* keep(Value value) const {
    return &nodes_.emplace_back(std::move(value));
  }

  const mustache::data* keep_list(const Json& data) const {
    mustache::data list{mustache::data::type::list};
    for (std::size_t i = 0; i < data.size(); ++i) list << mustache::data{true};
    const mustache::data& node = nodes_.emplace_back(std::move(list));
    for (std::size_t i = 0; i < data.size(); ++i) {
      source_[&node.list_value()[i]] = {&data[i], {i == 0, i + 1 == data.size()}};
    }
    return &node;
  }

  struct Place {
    bool first, last;  ///< of its list
  };
  struct Source {
    const Json* data;
    Place place;
  };

  Scopes scopes_;
  std::vector<Place> places_ = {{true, true}};  // of the scopes
  mutable std::deque<mustache::data> nodes_;    // addresses must remain valid
  mutable std::unordered_map<const mustache::data*, Source> source_;
};

}  // namespace

const Json& found_in(const Scopes& scopes, const std::string& name) {
  if (name == "." && !scopes.empty()) return *scopes.back();
  for (auto scope = scopes.rbegin(); scope != scopes.rend(); ++scope) {
    if (const Json* data = looked_up(**scope, name)) return *data;
  }
  throw std::logic_error(
      fmt::format("a template asks for \"{}\", which the data do not have", name));
}

bool is_yes(const Json& data) {
  if (data.is_boolean()) return data.get<bool>();
  if (data.is_string()) return !data.get_ref<const std::string&>().empty();
  return !data.is_null() && !(data.is_array() && data.empty());
}

std::string filled(const std::string& text, const Scopes& scopes) {
  mustache::mustache sheet(text);
  sheet.set_custom_escape([](const std::string& plain) { return plain; });
  Context context(scopes);
  std::string result = sheet.render(context);
  if (!sheet.is_valid()) {
    throw std::logic_error(fmt::format("a template, \"{}\": {}", text, sheet.error_message()));
  }
  return result;
}

Json rounded(double number, int digits) {
  constexpr double exact = 9007199254740992.0;  // 2^53: whole numbers below it are exact
  if (!std::isfinite(number)) return nullptr;
  const auto whole = [&](double of) { return of == std::trunc(of) && std::abs(of) < exact; };
  double kept = number;  // also if it is too large to be rounded
  if (!whole(number)) {
    const std::string text = fmt::format("{:.{}g}", number, digits);
    std::from_chars(text.data(), text.data() + text.size(), kept);
  }
  if (whole(kept)) return static_cast<std::int64_t>(kept);
  return kept;
}

namespace {

constexpr int deepest_data = 100;  // functions here call themselves for every level

/// NOTE: an entry of a list is rounded by the name of the list.
Json all_rounded(Json data, const Digits& known, int digits) {
  if (data.is_number_float()) return rounded(data.get<double>(), digits);
  if (data.is_array()) {
    for (Json& entry : data) entry = all_rounded(std::move(entry), known, digits);
  } else if (data.is_object()) {
    for (auto& [name, value] : data.items()) {
      const auto own = known.find(name);
      value = all_rounded(std::move(value), known, own == known.end() ? usual_digits : own->second);
    }
  }
  return data;
}

/// Writes short values on one line, fills lines with plain values of a list, and puts everything
/// else on lines of its own.
class Writer {
 public:
  std::string text(const Json& data) {
    write(data);
    return std::move(text_) + "\n";
  }

 private:
  static constexpr std::size_t longest_line = 120;

  void write(const Json& data) {
    std::string line = data.dump();
    if (line.size() <= longest_line || !data.is_structured()) {
      text_ += line;
    } else if (data.is_object()) {
      write_members(data);
    } else {
      write_entries(data);
    }
  }

  void write_members(const Json& object) {
    const char* before = "{\n";
    for (const auto& [name, value] : object.items()) {
      text_ += before + Json(name).dump() + ":";
      write(value);
      before = ",\n";
    }
    text_ += "\n}";
  }

  void write_entries(const Json& list) {
    text_ += "[\n";
    std::size_t start = text_.size();
    for (const Json& entry : list) {
      if (&entry != &list.front()) text_ += ',';
      const bool breaks =
          text_.size() > start && (entry.is_structured() || text_.size() - start > longest_line);
      if (breaks) {
        text_ += '\n';
        start = text_.size();
      }
      write(entry);
    }
    text_ += "\n]";
  }

  std::string text_;
};

}  // namespace

std::string json_text(const Json& data) {
  return Writer().text(data);
}

std::string data_text(const Json& data, const Digits& digits) {
  return Writer().text(packed(all_rounded(data, digits, usual_digits)));
}

Json data_in(const std::string& text) {
  const auto shallow = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest_data)
      throw std::logic_error(fmt::format("is nested deeper than {}", deepest_data));
    return true;
  };
  Json data = Json::parse(text, shallow);
  // NOTE: tables of pages of Markdown keep their columns.
  const bool has_results = data.is_object() && data.contains("report") &&
                           (data.contains("tables") || data.contains("values"));
  return has_results ? data : unpacked(data);
}

}  // namespace ricochet::report
