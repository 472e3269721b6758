#include "src/core/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "ricochet/error.h"
#include "src/core/names.h"

namespace ricochet {

namespace {

bool looks_like_a_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text[0]) != std::string_view::npos &&
         !number_of_text<double>(text);
}

}  // namespace

std::string csv_field(std::string_view text) {
  std::string field(looks_like_a_formula(text) ? "'" : "");
  field += text;
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

namespace {

constexpr std::size_t longest_csv = 16'000'000;  // bytes

std::string trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
    comma = line.find(',', begin);
    fields.push_back(trimmed(std::string_view(line).substr(begin, comma - begin)));
  }
  return fields;
}

void check_names(const CsvTable& table, int line, const std::vector<std::string>& known) {
  for (auto name = table.names.begin(); name != table.names.end(); ++name) {
    if (std::ranges::find(known, *name) == known.end()) {
      throw InputError(fmt::format("{}:{}: column {}: {}", table.origin, line, one_line(*name),
                                   what_instead(*name, known)));
    }
    if (std::find(table.names.begin(), name, *name) != name) {
      throw InputError(fmt::format("{}:{}: column {} is there twice", table.origin, line, *name));
    }
  }
}

double number_of(const std::string& field, const CsvTable& table, int line,
                 const std::string& name) {
  const auto number = number_of_text<double>(field.starts_with('+') ? field.substr(1) : field);
  if (!number || !std::isfinite(*number)) {
    throw InputError(fmt::format("{}:{}: column {}: '{}': must be a finite number", table.origin,
                                 line, name, one_line(field)));
  }
  return *number;
}

}  // namespace

const std::vector<double>* CsvTable::find(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const std::vector<double>* found = find(name);
  if (found == nullptr) {
    throw InputError(fmt::format("{}: must have the column {}", origin, name));
  }
  return *found;
}

void CsvTable::refuse(std::size_t row, const std::string& name, double number,
                      const std::string& demand) const {
  throw InputError(
      fmt::format("{}:{}: column {}: {}: must be {}", origin, lines[row], name, number, demand));
}

CsvTable parse_csv_table(const std::string& text, const std::string& origin,
                         const std::vector<std::string>& known) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // that spreadsheets write
  CsvTable table{origin, {}, {}, {}};
  std::istringstream stream(text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size())
                                                              : text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (trimmed(line).empty() || line.starts_with('#')) continue;
    const std::vector<std::string> fields = fields_of(line);
    if (table.names.empty()) {
      table.names = fields;
      check_names(table, number, known);
      table.columns.resize(fields.size());
      continue;
    }
    if (fields.size() != table.names.size()) {
      throw InputError(fmt::format("{}:{}: {} fields: must be {}, as in the header", origin, number,
                                   fields.size(), table.names.size()));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      table.columns[i].push_back(number_of(fields[i], table, number, table.names[i]));
    }
    table.lines.push_back(number);
  }
  if (table.lines.empty()) {
    throw InputError(
        fmt::format("{}: must have a header, such as {}, and lines of numbers", origin, known[0]));
  }
  return table;
}

CsvTable read_csv_table(const std::string& path, const std::vector<std::string>& known) {
  std::string text(longest_csv + 1, '\0');
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    throw InputError(
        fmt::format("{}: cannot be read: {}", path, std::generic_category().message(errno)));
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > longest_csv) {
    throw InputError(fmt::format("{}: too long: must have at most {} bytes", path, longest_csv));
  }
  return parse_csv_table(text, path, known);
}

}  // namespace ricochet
