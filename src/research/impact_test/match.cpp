#include "src/research/impact_test/match.h"

#include <algorithm>
#include <cmath>

namespace ricochet::studies::impact_test {
namespace {

using carrier_track::Impact;
using carrier_track::Wall;

std::vector<std::size_t> places_on(Wall wall, const std::vector<Impact>& impacts) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    if (impacts[k].wall == wall) places.push_back(k);
  }
  return places;
}

/// The best pairing of the impacts on one wall, by dynamic programming over the beginnings of both
/// lists.
class Pairing {
 public:
  Pairing(const std::vector<Impact>& rows, const std::vector<Impact>& columns, Wall wall,
          double apart)
      : rows_(rows),
        columns_(columns),
        row_(places_on(wall, rows)),
        column_(places_on(wall, columns)),
        apart_(apart),
        worth_((row_.size() + 1) * (column_.size() + 1)) {
    for (std::size_t i = 1; i <= row_.size(); ++i) {
      for (std::size_t j = 1; j <= column_.size(); ++j) {
        double best = std::max(worth(i - 1, j), worth(i, j - 1));
        const double with_pair = worth(i - 1, j - 1) + worth_of_pair(i, j);
        worth_[i * (column_.size() + 1) + j] = std::max(best, with_pair);
      }
    }
  }

  void write(std::vector<std::optional<std::size_t>>& partners) const {
    std::size_t i = row_.size();
    std::size_t j = column_.size();
    while (i > 0 && j > 0) {
      if (worth(i, j) == worth(i - 1, j)) {
        --i;
      } else if (worth(i, j) == worth(i, j - 1)) {
        --j;
      } else {
        partners[row_[--i]] = column_[--j];
      }
    }
  }

 private:
  double worth(std::size_t i, std::size_t j) const { return worth_[i * (column_.size() + 1) + j]; }

  /// One pair more is worth more than any sum of differences; nothing for those too far apart.
  double worth_of_pair(std::size_t i, std::size_t j) const {
    const double difference =
        std::abs(rows_[row_[i - 1]].time - columns_[column_[j - 1]].time) / apart_;
    if (!(difference <= 1)) return 0;
    return static_cast<double>(row_.size() + 1) - difference;
  }

  const std::vector<Impact>&rows_, &columns_;
  const std::vector<std::size_t> row_, column_;
  const double apart_;
  std::vector<double> worth_;
};

}  // namespace

std::vector<std::optional<std::size_t>> partners_of(const std::vector<Impact>& true_ones,
                                                    const std::vector<Impact>& found,
                                                    double apart) {
  std::vector<std::optional<std::size_t>> partners(true_ones.size());
  for (const Wall wall : {Wall::lower, Wall::upper}) {
    Pairing(true_ones, found, wall, apart).write(partners);
  }
  return partners;
}

}  // namespace ricochet::studies::impact_test
