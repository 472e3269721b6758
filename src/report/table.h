#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

enum class Alignment { left, right };

/// Good and bad are also shown as a tick and a cross, since not every reader sees colours.
enum class State { neutral, good, bad };

struct Column {
  std::string title;
  Alignment alignment = Alignment::right;
};

struct Cell {
  std::string text;
  State state = State::neutral;
  std::string link = {};  ///< see Link in headline.h; empty: none
};

/// The first cell of every row is its header.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

}  // namespace ricochet::report
