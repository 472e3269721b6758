#include "src/report/data_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "src/report/record_table.h"

namespace ricochet::report {
namespace {

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

constexpr int deepest_data = 100;  // functions here call themselves for every level

/// NOTE: an entry of a list is rounded by the name of the list.
Json rounded(Json data, const Digits& known, int digits) {
  if (data.is_number_float()) return rounded(data.get<double>(), digits);
  if (data.is_array()) {
    for (Json& entry : data) entry = rounded(std::move(entry), known, digits);
  } else if (data.is_object()) {
    for (auto& [name, value] : data.items()) {
      const auto own = known.find(name);
      value = rounded(std::move(value), known, own == known.end() ? usual_digits : own->second);
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

std::string data_text(const Json& data, const Digits& digits) {
  return Writer().text(packed(rounded(data, digits, usual_digits)));
}

Json data_in(const std::string& text) {
  const auto shallow = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest_data)
      throw std::logic_error(fmt::format("is nested deeper than {}", deepest_data));
    return true;
  };
  return unpacked(Json::parse(text, shallow));
}

}  // namespace ricochet::report
