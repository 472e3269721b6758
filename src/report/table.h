#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

enum class Alignment { left, right };

/// Good and bad show as a tick and a cross, too: colour alone does not reach everyone.
enum class State { neutral, good, bad };

struct Column {
  std::string title;
  Alignment alignment = Alignment::right;
};

struct Cell {
  std::string text;
  State state = State::neutral;
};

struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

/// GitHub's Markdown, with the caption as a paragraph before. Throws std::invalid_argument where a
/// row is longer or shorter than the columns, as does to_html.
std::string to_markdown(const Table& table);

/// One <table>; the first cell of every row is its header.
std::string to_html(const Table& table);

}  // namespace ricochet::report
