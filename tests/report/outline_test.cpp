#include "src/report/outline.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::report {
namespace {

Outline box_at(double left, double top, double width = 10, double height = 5) {
  return {{{left, top + height}, {left + width, top + height}, {left + width, top}, {left, top}},
          true};
}

/// The middles of cells of 10 x 5 that boxes cover, each as often as it is covered.
std::multiset<Pixel> cells_under(const std::vector<Outline>& boxes) {
  std::multiset<Pixel> cells;
  for (const Outline& box : boxes) {
    for (double x = 5; x < 100; x += 10) {
      for (double y = 2.5; y < 100; y += 5) {
        const Pixel low = box.corners[0], high = box.corners[2];
        if (low.x < x && x < high.x && high.y < y && y < low.y) cells.insert({x, y});
      }
    }
  }
  return cells;
}

TEST(Outline, JoinsNeighboursAcrossAndThenUp) {
  EXPECT_EQ(joined_rectangles({box_at(0, 5), box_at(10, 5), box_at(30, 5)}),
            (std::vector<Outline>{box_at(0, 5, 20), box_at(30, 5)}));
  EXPECT_EQ(joined_rectangles({box_at(0, 5), box_at(10, 5), box_at(0, 0), box_at(10, 0)}),
            (std::vector<Outline>{box_at(0, 0, 20, 10)}));
}

TEST(Outline, CoversWhatWasCovered) {
  std::vector<Outline> cells;
  for (int row = 9; row >= 0; --row) {
    for (int column = 0; column < 9; ++column) {
      if ((row * 7 + column * 5) % 3 != 0) cells.push_back(box_at(10 * column, 5 * row));
    }
  }
  const auto joined = joined_rectangles(cells);
  EXPECT_LT(joined.size(), cells.size());
  EXPECT_EQ(cells_under(joined), cells_under(cells));
}

TEST(Outline, LeavesWhatIsNoRectangle) {
  const Outline triangle{{{0, 0}, {4, 0}, {0, 4}}, true};
  const Outline slanted{{{0, 0}, {4, 1}, {5, 5}, {1, 4}}, true};
  EXPECT_EQ(joined_rectangles({triangle, slanted}), (std::vector<Outline>{triangle, slanted}));
}

}  // namespace
}  // namespace ricochet::report
