#include "src/report/names_of_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "src/report/quote.h"
#include "src/report/script.h"

namespace ricochet::report {
namespace {

/// In pixels, from the lower left corner of the plot.
struct Box {
  double left, right, bottom, top;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
  }
};

struct Place {
  double x, y;  ///< from the dot to the text's nearer end, pixels
  bool to_the_left;
  bool led;
  Box box;
};

class Names {
 public:
  Names(const Chart& chart, const Frame& frame)
      : chart_(chart),
        frame_(frame),
        width_(plot_width(chart, frame)),
        height_(plot_height(chart)) {
    constexpr double dot = 4;
    for (const Series& series : chart.series) {
      if (series.mark != Mark::points) continue;
      for (const Sample& sample : series.samples) {
        if (!sample.value) continue;
        const double x = across(sample);
        const double y = up(sample);
        taken_.push_back({x - dot, x + dot, y - dot, y + dot});
      }
    }
  }

  std::string text() {
    std::string script;
    for (const bool pale : {false, true}) {
      for (const Series& series : chart_.series) {
        if (series.pale != pale) continue;
        for (const Sample& sample : series.samples) {
          if (sample.value && !sample.name.empty()) script += placed(sample, pale);
        }
      }
    }
    return script;
  }

 private:
  static double share(double value, const Range& range, Scale scale) {
    if (scale == Scale::linear) return (value - range.lower) / (range.upper - range.lower);
    return std::log(value / range.lower) / std::log(range.upper / range.lower);
  }
  double across(const Sample& sample) const {
    return width_ * share(sample.position, frame_.x, chart_.x.scale);
  }
  double up(const Sample& sample) const {
    return height_ * share(*sample.value, frame_.y, chart_.y.scale);
  }

  std::optional<Place> place_of(const Sample& sample, bool pale) const {
    constexpr double letter = 6.2;
    constexpr double half_line = 6.5;
    const double length = letter * static_cast<double>(sample.name.size());
    struct Direction {
      double x, y;
    };
    constexpr std::array<Direction, 8> directions{{{-0.8, 1.2},
                                                   {-1, 0},
                                                   {0.8, 1.2},
                                                   {0.8, -1.2},
                                                   {1, 0},
                                                   {-0.8, -1.2},
                                                   {0.1, 2.2},
                                                   {0.1, -2.2}}};
    for (const double distance : {8.0, 16.0, 26.0, 40.0}) {
      const bool led = distance > 8;
      if (led && pale) break;
      for (const Direction& direction : directions) {
        const double x = distance * direction.x;
        const double y = distance * direction.y;
        const double from = across(sample) + x;
        const double middle = up(sample) + y;
        const bool to_the_left = direction.x < 0;
        const Box box{to_the_left ? from - length : from, to_the_left ? from : from + length,
                      middle - half_line, middle + half_line};
        const bool inside =
            box.left > 0 && box.right < width_ && box.bottom > 0 && box.top < height_ + half_line;
        const bool free =
            std::ranges::none_of(taken_, [&](const Box& other) { return other.meets(box); });
        if (inside && free) return Place{x, y, to_the_left, led, box};
      }
    }
    return std::nullopt;
  }

  std::string placed(const Sample& sample, bool pale) {
    const std::optional<Place> place = place_of(sample, pale);
    if (!place) return "";
    taken_.push_back(place->box);
    const double right = place->x / width_;
    const double high = place->y / height_;
    std::string script;
    if (place->led) {
      script = fmt::format(
          "set arrow from {0:.6g},{1:.6g} rto graph {2:.4f},{3:.4f} nohead lw 0.6 lc rgb "
          "'#888888'\n",
          sample.position, *sample.value, right, high);
    }
    return script + fmt::format(
                        "set label {} at {:.6g},{:.6g} {} offset graph {:.4f},{:.4f} font '{},10' "
                        "tc rgb '{}'\n",
                        quoted(sample.name), sample.position, *sample.value,
                        place->to_the_left ? "right" : "left", right, high, body_font,
                        pale ? "#8a8a8a" : "#222222");
  }

  const Chart& chart_;
  const Frame& frame_;
  double width_, height_;
  std::vector<Box> taken_;
};

}  // namespace

std::string names_of_points(const Chart& chart, const Frame& frame) {
  return Names(chart, frame).text();
}

}  // namespace ricochet::report
