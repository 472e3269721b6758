#include "src/report/names_of_points.h"

#include <algorithm>
#include <array>

#include "src/report/wrapped.h"

namespace ricochet::report {
namespace {

constexpr double dot_size = 4;  // half, pixels
constexpr double half_line = 6.5;

bool meet(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

class Names {
 public:
  Names(const Chart& chart, const Frame& frame) : chart_(chart), frame_(frame) {
    for (const Series& series : chart.series) {
      if (series.mark != Mark::points) continue;
      for (const Sample& sample : series.samples) {
        if (!sample.value) continue;
        const Pixel dot = place_of(chart, frame, sample.position, *sample.value);
        taken_.push_back({dot.x - dot_size, dot.x + dot_size, dot.y - dot_size, dot.y + dot_size});
      }
    }
  }

  std::vector<PointName> all() {
    for (const bool pale : {false, true}) {
      for (const Series& series : chart_.series) {
        if (series.pale != pale) continue;
        for (const Sample& sample : series.samples) {
          if (sample.value && !sample.name.empty()) place(sample, pale);
        }
      }
    }
    return std::move(placed_);
  }

 private:
  void place(const Sample& sample, bool pale) {
    static constexpr std::array<Pixel, 8> directions{{{-0.8, -1.2},
                                                      {-1, 0},
                                                      {0.8, -1.2},
                                                      {0.8, 1.2},
                                                      {1, 0},
                                                      {-0.8, 1.2},
                                                      {0.1, -2.2},
                                                      {0.1, 2.2}}};
    const Pixel dot = place_of(chart_, frame_, sample.position, *sample.value);
    if (!frame_.plot.holds(dot)) return;
    for (const double distance : {8.0, 16.0, 26.0, 40.0}) {
      const bool led = distance > 8;
      if (led && pale) return;
      for (const Pixel& direction : directions) {
        const PointName name{
            sample.name,     dot, {dot.x + distance * direction.x, dot.y + distance * direction.y},
            direction.x < 0, led, pale};
        if (take(name)) return;
      }
    }
  }

  /// Keeps the name if there is room for it.
  bool take(const PointName& name) {
    const double length = text_width(name.text, 10) + 2;
    const double left = name.to_the_left ? name.place.x - length : name.place.x;
    const Box box{left, left + length, name.place.y - half_line, name.place.y + half_line};
    const Box& plot = frame_.plot;
    const bool inside = box.left > plot.left && box.right < plot.right &&
                        box.bottom < plot.bottom && box.top > plot.top - half_line;
    if (!inside || std::ranges::any_of(taken_, [&](const Box& b) { return meet(b, box); })) {
      return false;
    }
    taken_.push_back(box);
    placed_.push_back(name);
    return true;
  }

  const Chart& chart_;
  const Frame& frame_;
  std::vector<Box> taken_;
  std::vector<PointName> placed_;
};

}  // namespace

std::vector<PointName> names_of_points(const Chart& chart, const Frame& frame) {
  return Names(chart, frame).all();
}

}  // namespace ricochet::report
