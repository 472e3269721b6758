#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "src/analysis/comparison/view.h"

namespace ricochet::studies::comparison {
namespace {

TEST(ViewOrderText, IsThisOfTheseRuns) {
  ViewOrderWriter order;
  order.add({0, 0, 1}, {5, 10});
  EXPECT_EQ(order.text(), "") << "the first needs no place";
  order.add({0, 0, 1}, {5, 10});  // equal to it: 1 of 3, two bits
  order.add({0, 1, 1}, {4, 10});  // another run
  order.add({0, 0, 2}, {6, 10});  // with other targets missing
  order.add({1, 0, 1}, {4, 10});  // another problem
  EXPECT_EQ(order.text(), "B");
  order.add({0, 0, 1}, {5, 9});   // before both: 0 of 3, two bits
  order.add({0, 0, 1}, {7, 10});  // after two values: 4 of 5, three bits: 1, 0 and 0, 0, 1
  EXPECT_EQ(order.text(), "BB");
}

/// Reads bit by bit from the text and rebuilds the order of runs that are all ranked together.
std::vector<std::size_t> places_in(const std::string& text, std::size_t runs) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::size_t at = 0;
  std::vector<std::vector<std::size_t>> values;
  for (std::size_t run = 0; run < runs; ++run) {
    std::size_t position = 0;
    for (std::size_t weight = 1; weight <= 2 * values.size(); weight *= 2, ++at) {
      position += weight * (digits.find(text.at(at / 6)) >> (at % 6) & 1U);
    }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(position / 2);
    if (position % 2 == 1) {
      place->push_back(run);
    } else {
      values.insert(place, {run});
    }
  }
  std::vector<std::size_t> places(runs);
  for (std::size_t place = 0; place < values.size(); ++place) {
    for (const std::size_t run : values[place]) places[run] = place;
  }
  return places;
}

TEST(ViewOrderText, GivesTheOrderBack) {
  std::mt19937 random(3);
  for (const unsigned many : {3U, 40U, 1000U}) {
    ViewOrderWriter order;
    std::vector<std::pair<double, double>> reached;
    for (int k = 0; k < 200; ++k) {
      reached.emplace_back(random() % many, random() % 2);
      if (k % 50 == 0) reached.back().first = std::numeric_limits<double>::infinity();
      order.add({4, 2, 9}, {reached.back().first, reached.back().second});
    }
    const std::set<std::pair<double, double>> sorted(reached.begin(), reached.end());
    const std::vector<std::size_t> places = places_in(order.text(), reached.size());
    for (std::size_t k = 0; k < reached.size(); ++k) {
      EXPECT_EQ(places[k],
                static_cast<std::size_t>(std::distance(sorted.begin(), sorted.find(reached[k]))));
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::comparison
