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

/// The first cell of every row is its header.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

}  // namespace ricochet::report
