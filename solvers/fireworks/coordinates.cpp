#include "solvers/fireworks/coordinates.h"

#include <cmath>
#include <utility>

#include "solvers/fireworks/draws.h"

namespace ricochet::fireworks {

std::span<const Eigen::Index> Coordinates::first(std::size_t count, Random& random) {
  if (count < all_.size()) {
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(all_[i], all_[i + one_of(all_.size() - i, random)]);
    }
  }
  return {all_.data(), count};
}

std::span<const Eigen::Index> Coordinates::draw(Moved moved, Random& random) {
  const auto dimension = static_cast<double>(all_.size());
  switch (moved) {
    case Moved::rounded:
      return first(static_cast<std::size_t>(std::round(dimension * share(random))), random);
    case Moved::ceiled:  // 1 - U is never 0
      return first(static_cast<std::size_t>(std::ceil(dimension * (1 - share(random)))), random);
    case Moved::coins: {
      std::size_t heads = 0;
      for (std::size_t i = 0; i < all_.size(); ++i) {
        if (toss(random)) std::swap(all_[heads++], all_[i]);
      }
      return {all_.data(), heads};
    }
    case Moved::all:
      break;
  }
  return all_;
}

}  // namespace ricochet::fireworks
