#include "src/report/path_data.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "src/report/simplified.h"

namespace ricochet::report {
namespace {

std::string text_of(long tenths) {
  const long size = std::labs(tenths);
  std::string text = tenths < 0 ? "-" : "";
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += fmt::format(".{}", size % 10);
  return text;
}

long whole_tenths(double pixels) {
  return std::lround(10 * pixels);
}

/// Writes path data and keeps the current position.
class Pen {
 public:
  void move(const Pixel& to) { go('M', 'm', to); }

  void draw(const Pixel& to) {
    const long across = whole_tenths(to.x) - x_, down = whole_tenths(to.y) - y_;
    if (across == 0 && down == 0) return;
    if (down == 0) {
      write('h', {across});
    } else if (across == 0) {
      write('v', {down});
    } else {
      write('l', {across, down});
    }
    x_ += across;
    y_ += down;
  }

  void dot() { write('h', {0}); }

  void circle(double radius) {
    const long r = whole_tenths(radius);
    write('m', {-r, 0});
    write('a', {r, r, 0, 10, 0, 2 * r, 0});
    write('a', {r, r, 0, 10, 0, -2 * r, 0});
    text_ += 'z';
    last_ = 'z';
    x_ -= r;
  }

  /// Back to where the outline began.
  void close(const Pixel& start) {
    text_ += 'z';
    last_ = 'z';
    x_ = whole_tenths(start.x);
    y_ = whole_tenths(start.y);
  }

  const std::string& text() const { return text_; }

 private:
  void go(char absolute, char relative, const Pixel& to) {
    const long x = whole_tenths(to.x), y = whole_tenths(to.y);
    if (text_.empty()) {
      write(absolute, {x, y});
    } else {
      write(relative, {x - x_, y - y_});
    }
    x_ = x;
    y_ = y;
  }

  /// Omits a repeated command, and a space before a sign or a decimal point.
  void write(char command, std::initializer_list<long> numbers) {
    bool after_a_number = command == last_ && command != 'M' && command != 'm';
    if (!after_a_number) text_ += command;
    last_ = command;
    for (const long number : numbers) {
      const std::string text = text_of(number);
      const bool parts = text[0] == '-' || (text[0] == '.' && ends_in_a_fraction_);
      if (after_a_number && !parts) text_ += ' ';
      text_ += text;
      ends_in_a_fraction_ = number % 10 != 0;
      after_a_number = true;
    }
  }

  std::string text_;
  char last_ = ' ';
  bool ends_in_a_fraction_ = false;
  long x_ = 0, y_ = 0;
};

std::vector<Pixel> needed(const Outline& outline) {
  std::vector<Pixel> corners;
  for (const std::size_t i : needed_corners(outline.corners, 0.1))
    corners.push_back(outline.corners[i]);
  return corners;
}

/// The coordinates of an outline in the order in which it is written.
std::vector<long> places_of(const std::vector<Pixel>& corners, const Outline& outline) {
  std::vector<long> places = {outline.closed ? 1 : 0, whole_tenths(outline.radius)};
  for (const Pixel& corner : corners) {
    places.insert(places.end(), {whole_tenths(corner.x), whole_tenths(corner.y)});
  }
  return places;
}

}  // namespace

std::string path_data(const std::vector<Outline>& outlines) {
  Pen pen;
  std::set<std::vector<long>> drawn;
  for (const Outline& outline : outlines) {
    const std::vector<Pixel> corners = needed(outline);
    if (corners.empty() || !drawn.insert(places_of(corners, outline)).second) continue;
    pen.move(corners.front());
    if (outline.radius > 0) {
      pen.circle(outline.radius);
      continue;
    }
    if (corners.size() == 1) pen.dot();
    for (std::size_t i = 1; i < corners.size(); ++i) pen.draw(corners[i]);
    if (outline.closed) pen.close(corners.front());
  }
  return pen.text();
}

}  // namespace ricochet::report
