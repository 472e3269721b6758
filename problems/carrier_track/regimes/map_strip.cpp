#include "problems/carrier_track/regimes/map_strip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double same_border = 1e-7;  // relative, of the speed
constexpr double alike = 1.0;         // of ln(speed), of borders that are matched
constexpr double sliver = 1e-7;       // relative: what rounding leaves between two solutions

double place_in(const MapColumn& left, const MapColumn& right, std::size_t part) {
  if (part == strip_parts) return right.constant;
  const double share = static_cast<double>(part) / static_cast<double>(strip_parts);
  return left.constant + share * (right.constant - left.constant);
}

/// The border of a column at that speed.
std::optional<std::size_t> border_at(const MapColumn& column, double omega, RegimeEnd kind) {
  for (std::size_t i = 0; i + 1 < column.regimes.size(); ++i) {
    const Regime& regime = column.regimes[i];
    if (regime.ends_by == kind && std::abs(regime.to / omega - 1) < same_border) return i;
  }
  return std::nullopt;
}

/// Follows one border of a column, number `border`, to the other column.
class Follower {
 public:
  Follower(const MapColumn& near, const MapColumn& far, const RegimeMapOptions& options)
      : near_(near), far_(far), options_(options) {}

  /// `left` and `right` of the result stand for the near and the far column.
  StripLink from(std::size_t border) const {
    const Regime& regime = near_.regimes[border];
    StripLink link{border, std::nullopt, {{near_.constant, regime.to, std::nullopt}}};
    try {
      BorderCurve curve(border_between(regime, near_.regimes[border + 1]), options_.constant);
      link.points.front().slope = curve.here().slope;
      lead(curve, link);
    } catch (const std::invalid_argument&) {
      link.end = CurveEnd::not_sharp;
      return link;
    }
    if (!link.leads_through()) return link;
    const double there = link.points.back().omega;
    if (is_outside(there)) {
      link.end = CurveEnd::speeds;
    } else if (!(link.right = border_at(far_, there, regime.ends_by))) {
      link.end = CurveEnd::other_motion;
      link.points.resize(1);
    }
    return link;
  }

 private:
  bool is_outside(double omega) const {
    return omega >= options_.speeds.to || omega <= options_.speeds.from;
  }

  void lead(BorderCurve& curve, StripLink& link) const {
    bool outside = false;
    for (std::size_t part = 1; part <= strip_parts; ++part) {
      const double there = place_in(near_, far_, part);
      const bool arrives = curve.follow_to(there);
      const BorderPoint& here = curve.here();
      outside = outside || is_outside(here.omega);
      if (arrives) {
        link.points.push_back({there, here.omega, here.slope});
      } else if (outside) {  // what it does there does not matter
        link.points.push_back({there, here.omega, std::nullopt});
      } else {
        link.end = curve.end();
        if (here.constant != link.points.back().constant) {
          link.points.push_back({here.constant, here.omega, here.slope});
        }
        // Not to be mistaken for one that leads through.
        if (link.leads_through()) link.points.erase(link.points.begin() + 1);
        return;
      }
    }
  }

  const MapColumn& near_;
  const MapColumn& far_;
  const RegimeMapOptions& options_;
};

/// Borders of one kind and with the same counts, in the order of their speeds.
std::vector<StripLink> matched(const MapColumn& left, const MapColumn& right) {
  const auto key = [](const MapColumn& column, std::size_t i) {
    const Regime& a = column.regimes[i];
    const Regime& b = column.regimes[i + 1];
    return std::make_tuple(a.ends_by, a.least_per_turn, a.most_per_turn, b.least_per_turn,
                           b.most_per_turn);
  };
  std::vector<StripLink> links;
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < left.regimes.size(); ++i) {
    StripLink link{i, std::nullopt, {{left.constant, left.regimes[i].to, std::nullopt}}};
    link.end = CurveEnd::not_sharp;
    for (std::size_t j = next; j + 1 < right.regimes.size(); ++j) {
      const double from = left.regimes[i].to, to = right.regimes[j].to;
      if (key(left, i) != key(right, j) || std::abs(std::log(to / from)) > alike) continue;
      for (std::size_t part = 1; part <= strip_parts; ++part) {
        const double share = static_cast<double>(part) / static_cast<double>(strip_parts);
        link.points.push_back(
            {place_in(left, right, part), from + share * (to - from), std::nullopt});
      }
      link.right = j;
      link.end = CurveEnd::range;
      next = j + 1;
      break;
    }
    links.push_back(link);
  }
  return links;
}

/// A range of speeds of a column with the same collisions.
struct Piece {
  double from, to;
  double collisions;
  bool certain;

  bool is_like(const Piece& other) const {
    return certain == other.certain && (collisions == other.collisions || !certain);
  }
};

/// The pieces of a column between two speeds; none beyond the range of speeds.
std::vector<Piece> pieces_of(const MapColumn& column, double from, double to) {
  std::vector<Piece> pieces;
  for (const Regime& regime : column.regimes) {
    Piece piece{std::max(from, regime.from), std::min(to, regime.to), regime.most_per_turn,
                regime.certain};
    if (piece.to - piece.from <= sliver * piece.to) continue;
    if (!pieces.empty() && pieces.back().is_like(piece)) {
      pieces.back().to = piece.to;
    } else {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/// The part of a strip between two of its borders.
class Gap {
 public:
  Gap(const MapColumn& left, const MapColumn& right, const StripLink& lower, const StripLink& upper)
      : lower_(lower), upper_(upper) {
    const auto between = [&](const MapColumn& column, std::size_t part) {
      return pieces_of(column, lower.points[part].omega, upper.points[part].omega);
    };
    left_ = between(left, 0);
    right_ = between(right, strip_parts);
    if (left_.empty()) left_ = right_;
    if (right_.empty()) right_ = left_;
  }

  void add_to(StripRegions& result) const {
    if (left_.empty()) return;
    if (left_.size() == 1 && right_.size() == 1 && left_[0].is_like(right_[0])) {
      add(result, left_, 0, 0, strip_parts);
      return;
    }
    result.whole = false;
    add(result, left_, 0, 0, strip_parts / 2);
    add(result, right_, strip_parts, strip_parts / 2, strip_parts);
  }

 private:
  void add(StripRegions& result, const std::vector<Piece>& pieces, std::size_t own,
           std::size_t first, std::size_t last) const {
    const double from = lower_.points[own].omega, to = upper_.points[own].omega;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      MapRegion region{pieces[i].collisions, pieces[i].certain, {}};
      for (std::size_t part = first; part <= last; ++part) {
        const MapPoint& low = lower_.points[part];
        const double high = upper_.points[part].omega;
        // Inner edges keep their share of the gap.
        const auto edge = [&](double omega) {
          return low.omega + (omega - from) / (to - from) * (high - low.omega);
        };
        const bool lowest = i == 0, highest = i + 1 == pieces.size();
        region.edges.push_back({low.constant, lowest ? low.omega : edge(pieces[i].from),
                                highest ? high : edge(pieces[i].to)});
      }
      result.regions.push_back(std::move(region));
    }
  }

  const StripLink& lower_;
  const StripLink& upper_;
  std::vector<Piece> left_, right_;
};

/// A line of one speed through a strip.
StripLink level(const MapColumn& left, const MapColumn& right, double omega) {
  StripLink link;
  for (std::size_t part = 0; part <= strip_parts; ++part) {
    link.points.push_back({place_in(left, right, part), omega, std::nullopt});
  }
  return link;
}

}  // namespace

std::vector<StripLink> strip_links(const MapColumn& left, const MapColumn& right,
                                   const RegimeMapOptions& options, bool followed) {
  const auto is_irregular = [](const Regime& regime) { return !regime.certain; };
  const bool sharp = std::ranges::none_of(left.regimes, is_irregular) &&
                     std::ranges::none_of(right.regimes, is_irregular);
  if (!followed || !sharp) return matched(left, right);
  std::vector<StripLink> links;
  std::vector<bool> reached(right.regimes.size(), false);
  const Follower onwards(left, right, options);
  for (std::size_t i = 0; i + 1 < left.regimes.size(); ++i) {
    links.push_back(onwards.from(i));
    if (links.back().right) reached[*links.back().right] = true;
  }
  const Follower back(right, left, options);
  for (std::size_t j = 0; j + 1 < right.regimes.size(); ++j) {
    if (reached[j]) continue;
    StripLink link = back.from(j);
    std::swap(link.left, link.right);
    std::reverse(link.points.begin(), link.points.end());
    links.push_back(std::move(link));
  }
  return links;
}

StripRegions strip_regions(const MapColumn& left, const MapColumn& right,
                           const std::vector<StripLink>& links, const RegimeMapOptions& options) {
  double highest = options.speeds.to;
  std::vector<StripLink> lines;
  for (const StripLink& link : links) {
    if (!link.leads_through()) continue;
    lines.push_back(link);
    for (const MapPoint& point : link.points) highest = std::max(highest, point.omega);
  }
  lines.push_back(level(left, right, 0));
  lines.push_back(level(left, right, 1.01 * highest));
  std::ranges::sort(lines, {}, [](const StripLink& line) { return line.points.front().omega; });
  // Of lines that cross or touch within the strip one is left.
  std::vector<StripLink> apart;
  for (const StripLink& line : lines) {
    const auto above = [&](const StripLink& other) {
      for (std::size_t part = 0; part <= strip_parts; ++part) {
        if (!(line.points[part].omega > other.points[part].omega)) return false;
      }
      return true;
    };
    if (apart.empty() || above(apart.back())) apart.push_back(line);
  }
  StripRegions result;
  for (std::size_t i = 0; i + 1 < apart.size(); ++i) {
    Gap(left, right, apart[i], apart[i + 1]).add_to(result);
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline regimes
