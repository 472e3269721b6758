#include "src/benchmark/experiment/store/sqlite_values.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace ricochet {
namespace {

static_assert(std::endian::native == std::endian::little, "blobs are little-endian");

[[noreturn]] void damaged(const SQLite::Column& column) {
  throw Damage(std::string("a value of ") + column.getName() + " is of no type that it has");
}

}  // namespace

void Use::bind(int parameter, double value) {
  if (std::isnan(value) || (value == 0 && std::signbit(value))) {
    statement_.bind(parameter, &value, sizeof value);
  } else {
    statement_.bind(parameter, value);
  }
}

void Use::bind(int parameter, const Vector& value) {
  // An empty vector is an empty blob, not NULL, which a null pointer would give.
  const void* coordinates = value.size() == 0 ? "" : static_cast<const void*>(value.data());
  statement_.bind(parameter, coordinates,
                  static_cast<int>(sizeof(double)) * static_cast<int>(value.size()));
}

std::int64_t Use::integer(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (!value.isInteger()) damaged(value);
  return value.getInt64();
}

int Use::count(int column) const {
  const std::int64_t number = integer(column);
  if (number >= 0 && number <= std::numeric_limits<int>::max()) return static_cast<int>(number);
  throw Damage(
      std::string(statement_.getColumn(column).getName()) +
      fmt::format(" is {}: must be from 0 to {}", number, std::numeric_limits<int>::max()));
}

double Use::number(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (value.isFloat()) return value.getDouble();
  double number = 0;
  if (!value.isBlob() || value.getBytes() != sizeof number) damaged(value);
  std::memcpy(&number, value.getBlob(), sizeof number);
  return number;
}

std::string Use::text(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  if (!value.isText()) damaged(value);
  return value.getString();
}

Vector Use::point(int column) const {
  const SQLite::Column value = statement_.getColumn(column);
  const int bytes = value.isBlob() ? value.getBytes() : 1;
  if (bytes % static_cast<int>(sizeof(double)) != 0) damaged(value);
  Vector x(bytes / static_cast<int>(sizeof(double)));
  if (bytes > 0) std::memcpy(x.data(), value.getBlob(), static_cast<std::size_t>(bytes));
  return x;
}

}  // namespace ricochet
