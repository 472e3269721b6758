#pragma once

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <stdexcept>
#include <string>

#include "src/core/vector.h"

namespace ricochet {

/// What is read is not what was written.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A statement to be used once more. What it was used for before is forgotten, even if it failed.
class Use {
 public:
  explicit Use(SQLite::Statement& statement) : statement_(statement) { statement_.tryReset(); }
  ~Use() { statement_.tryReset(); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

  /// Gives the parameters, from the first to the last.
  template <class... Values>
  Use& with(const Values&... values) {
    int parameter = 0;
    (bind(++parameter, values), ...);
    return *this;
  }

  bool next() { return statement_.executeStep(); }
  void execute() { statement_.exec(); }

  // A value of the row, counted from 0. They throw Damage where it is of another type, which
  // only a damaged file has.
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;
  Vector point(int column) const;
  bool is_null(int column) const { return statement_.isColumnNull(column); }

 private:
  void bind(int parameter, int value) { statement_.bind(parameter, value); }
  void bind(int parameter, std::int64_t value) { statement_.bind(parameter, value); }
  void bind(int parameter, const std::string& value) { statement_.bind(parameter, value); }
  void bind(int parameter, double value);
  void bind(int parameter, const Vector& value);

  /// NULL where there is none.
  template <class Value>
  void bind(int parameter, const Value* value) {
    if (value != nullptr) {
      bind(parameter, *value);
    } else {
      statement_.bind(parameter);
    }
  }

  SQLite::Statement& statement_;
};

}  // namespace ricochet
