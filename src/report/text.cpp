#include "src/report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string_view>

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

  /// NOTE: dump() does not always write the fewest digits, but 0.024140000000000002 for 0.02414.
  static std::string on_one_line(const Json& data) {
    if (data.is_number_float() && std::isfinite(data.get<double>()))
      return fmt::format("{}", data.get<double>());
    if (!data.is_structured()) return data.dump();
    std::string text = data.is_object() ? "{" : "[";
    for (const auto& [name, value] : data.items()) {
      if (text.size() > 1) text += ',';
      if (data.is_object()) text += Json(name).dump() + ":";
      text += on_one_line(value);
    }
    return text + (data.is_object() ? "}" : "]");
  }

  void write(const Json& data) {
    std::string line = on_one_line(data);
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

Json data_in(const std::string& text) {
  return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest_data)
      throw std::logic_error(fmt::format("is nested deeper than {}", deepest_data));
    return true;
  });
}

}  // namespace ricochet::report
