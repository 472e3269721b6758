#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet {

/// A text as a field of a CSV file: quoted where it must be (RFC 4180), and with a ' before it
/// where a spreadsheet would take it for a formula, since it begins with = + - @, a tab or a line
/// break. A number, such as -1.5 or -inf, stays as it is.
std::string csv_field(std::string_view text);

/// Numbers of a CSV file, by column.
struct CsvTable {
  std::string origin;  ///< for messages
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< as many as names, of one length >= 1
  std::vector<int> lines;                    ///< of the file, for each row; the first one is 1

  /// The column of this name; null if there is none.
  const std::vector<double>* find(const std::string& name) const;

  /// The column of this name. Throws InputError if there is none.
  const std::vector<double>& column(const std::string& name) const;

  /// Throws InputError, with file, line, column and value, unless `holds` for each number.
  template <class Holds>
  void require(const std::string& name, const Holds& holds, const std::string& demand) const {
    const std::vector<double>& numbers = column(name);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!holds(i, numbers[i])) refuse(i, name, numbers[i], demand);
    }
  }

 private:
  [[noreturn]] void refuse(std::size_t row, const std::string& name, double number,
                           const std::string& demand) const;
};

/// Reads a file with a header line of names from `known`, and lines of as many finite numbers,
/// separated by commas. Blank lines, lines that begin with # and a byte order mark are skipped.
/// Throws InputError, one line with file, line and column, for anything else.
CsvTable read_csv_table(const std::string& path, const std::vector<std::string>& known);

/// The same from a text.
CsvTable parse_csv_table(const std::string& text, const std::string& origin,
                         const std::vector<std::string>& known);

}  // namespace ricochet
