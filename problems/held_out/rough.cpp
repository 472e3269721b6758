#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "problems/held_out/held_out.h"
#include "ricochet/random.h"

namespace ricochet::held_out {

namespace {

using namespace classic;

constexpr const char* minimax =
    "Luksan and Vlcek (2000), Test problems for nonsmooth unconstrained and linearly constrained "
    "optimization, Institute of Computer Science, Prague, report 798";

/// Values alone, from a function of the point.
template <class Function>
Problem rough(const char* name, const char* source, Vector lower, Vector upper, Vector start,
              double best, Vector best_point, const char* provenance, Function function,
              bool jumps = false) {
  Problem problem =
      without_functions(stated("outside-rough", name, source, std::move(lower), std::move(upper),
                               std::move(start), best, std::move(best_point), provenance));
  problem.evaluate = [function](const Vector& x) { return Values{function(x), {}}; };
  problem.jumps = jumps;
  return problem;
}

Problem kinked(const char* name, Vector start, double best, Vector best_point,
               const char* provenance, double (*function)(const Vector& x)) {
  const Eigen::Index n = start.size();
  return rough(name, minimax, Vector::Constant(n, -10), Vector::Constant(n, 15), std::move(start),
               best, std::move(best_point), provenance, function);
}

double three_squares(const Vector& x, double first) {
  return std::max(
      {first, std::pow(2 - x[0], 2) + std::pow(2 - x[1], 2), 2 * std::exp(x[1] - x[0])});
}

std::vector<Problem> kinks() {
  Vector alternating(10);
  for (Eigen::Index i = 0; i < 10; ++i)
    alternating[i] = static_cast<double>(i % 2 == 0 ? i + 1 : -i - 1);
  alternating = alternating.cwiseMax(-10);
  return {
      kinked("cb2", Vector{{1, -0.1}}, 1.9522244939, Vector{{1.1390376, 0.8995599}},
             "published: 1.9522245; digits by a search",
             [](const Vector& x) { return three_squares(x, x[0] * x[0] + std::pow(x[1], 4)); }),
      kinked("cb3", Vector{{2, 2}}, 2, Vector{{1, 1}}, "published: 2, exact",
             [](const Vector& x) { return three_squares(x, std::pow(x[0], 4) + x[1] * x[1]); }),
      kinked("dem", Vector{{1, 1}}, -3, Vector{{0, -3}}, "published: -3, exact",
             [](const Vector& x) {
               return std::max(
                   {5 * x[0] + x[1], -5 * x[0] + x[1], x[0] * x[0] + x[1] * x[1] + 4 * x[1]});
             }),
      kinked("ql", Vector{{-1, 5}}, 7.2, Vector{{1.2, 2.4}}, "published: 7.2, exact",
             [](const Vector& x) {
               const double bowl = x.squaredNorm();
               return std::max(
                   {bowl, bowl + 10 * (-4 * x[0] - x[1] + 4), bowl + 10 * (-x[0] - 2 * x[1] + 6)});
             }),
      kinked("lq", Vector{{-0.5, -0.5}}, -std::numbers::sqrt2,
             Vector::Constant(2, 1 / std::numbers::sqrt2), "closed form",
             [](const Vector& x) { return -x.sum() + std::max(0.0, x.squaredNorm() - 1); }),
      kinked("mifflin-1", Vector{{0.8, 0.6}}, -1, Vector{{1, 0}}, "published: -1, exact",
             [](const Vector& x) { return -x[0] + 20 * std::max(0.0, x.squaredNorm() - 1); }),
      kinked("mifflin-2", Vector{{-1, -1}}, -1, Vector{{1, 0}}, "published: -1, exact",
             [](const Vector& x) {
               const double off = x.squaredNorm() - 1;
               return -x[0] + 2 * off + 1.75 * std::abs(off);
             }),
      kinked("wolfe", Vector{{3, 2}}, -8, Vector{{-1, 0}}, "published: -8, exact",
             [](const Vector& x) {
               const double a = x[0], b = std::abs(x[1]);
               if (a >= b) return 5 * std::sqrt(9 * a * a + 16 * b * b);
               return a > 0 ? 9 * a + 16 * b : 9 * a + 16 * b - std::pow(a, 9);
             }),
      kinked("rosen-suzuki", Vector{{0, 0, 0, 0}}, -44, Vector{{0, 1, 2, -1}},
             "published: -44, exact",
             [](const Vector& x) {
               const double a = x[0], b = x[1], c = x[2], d = x[3];
               const double f = a * a + b * b + 2 * c * c + d * d - 5 * a - 5 * b - 21 * c + 7 * d;
               const double bowl = x.squaredNorm();
               return f + 10 * std::max({0.0, bowl + a - b + c - d - 8,
                                         bowl + b * b + d * d - a - d - 10,
                                         bowl + a * a - d * d + 2 * a - b - d - 5});
             }),
      kinked("maxq-10", alternating, 0, Vector::Zero(10), "closed form",
             [](const Vector& x) { return x.cwiseAbs2().maxCoeff(); }),
      kinked("maxl-10", alternating, 0, Vector::Zero(10), "closed form",
             [](const Vector& x) { return x.cwiseAbs().maxCoeff(); }),
      kinked(
          "goffin-10", alternating, 0, Vector::Zero(10), "closed form: the largest is the mean",
          [](const Vector& x) { return static_cast<double>(x.size()) * x.maxCoeff() - x.sum(); })};
}

/// An ellipsoid in steps, as a coarse scale shows it: BBOB's function 7 without its rotations.
Problem step_ellipsoid() {
  return rough(
      "step-ellipsoid-5", "Hansen et al. (2009), BBOB, function 7, not rotated, without its slope",
      Vector::Constant(5, -5), Vector::Constant(5, 5), Vector::Constant(5, 3.3), 0,
      Vector::Constant(5, 1), "closed form: no term is negative",
      [](const Vector& x) {
        double sum = 0;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          const double t = x[i] - 1;
          const double step =
              std::abs(t) > 0.5 ? std::floor(0.5 + t) : std::floor(0.5 + 10 * t) / 10;
          sum += std::pow(10, 2 * static_cast<double>(i) / 4) * step * step;
        }
        return sum / 10;
      },
      true);
}

/// Himmelblau's function as an instrument of two decimals shows it.
Problem rounded_himmelblau() {
  return rough(
      "rounded-himmelblau", "Himmelblau (1972), rounded to 0.01", Vector{{-5, -5}}, Vector{{5, 5}},
      Vector{{0, 0}}, 0, Vector{{3, 2}}, "closed form: no value is negative",
      [](const Vector& x) {
        const double f = std::pow(x[0] * x[0] + x[1] - 11, 2) + std::pow(x[0] + x[1] * x[1] - 7, 2);
        return std::floor(100 * f + 0.5) / 100;
      },
      true);
}

/// Random numbers that every evaluation uses again.
std::shared_ptr<const std::vector<double>> common_numbers(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  auto numbers = std::make_shared<std::vector<double>>(count);
  for (double& each : *numbers) each = uniform(random);
  return numbers;
}

/// The mean cost of a day of a store that orders up to a level when its stock is below another.
Problem inventory() {
  const auto demand = common_numbers(2000, 1);
  return rough(
      "inventory", "(s, S) ordering, Scarf (1960): 2,000 days of exponential demand of mean 20",
      Vector{{0, 0}}, Vector{{150, 300}}, Vector{{75, 150}}, 116.409, Vector{{21, 75}},
      "scan of all whole levels",
      [demand](const Vector& x) {
        const double reorder = std::round(x[0]), up_to = std::round(std::max(x[0], x[1]));
        double stock = up_to, cost = 0;
        for (const double u : *demand) {
          if (stock < reorder) {
            cost += 64 + 2 * (up_to - stock);
            stock = up_to;
          }
          stock -= std::round(-20 * std::log(1 - u));
          cost += stock > 0 ? stock : -9 * stock;
        }
        return cost / static_cast<double>(demand->size());
      },
      true);
}

/// What two stations in a row cost by their rates, and by how long a customer stays.
Problem tandem_queue() {
  const auto numbers = common_numbers(3000, 2);
  return rough(
      "tandem-queue", "Lindley (1952): 1,000 customers through two stations, by their rates",
      Vector{{1.05, 1.05}}, Vector{{6, 6}}, Vector{{5, 5}}, 3.909760579405037,
      Vector{{2.401354038404235, 2.1801802012718072}}, "search: the same by three solvers",
      [numbers](const Vector& rates) {
        double arrival = 0, first = 0, second = 0, stay = 0;
        for (std::size_t i = 0; i + 2 < numbers->size(); i += 3) {
          const auto drawn = [&](std::size_t k) { return -std::log(1 - (*numbers)[i + k]); };
          arrival += drawn(0);
          first = std::max(arrival, first) + drawn(1) / rates[0];
          second = std::max(first, second) + drawn(2) / rates[1];
          stay += second - arrival;
        }
        return stay / (static_cast<double>(numbers->size()) / 3) + 0.4 * rates[0] + 0.7 * rates[1];
      });
}

}  // namespace

std::vector<Problem> rough_problems() {
  std::vector<Problem> problems = kinks();
  problems.push_back(step_ellipsoid());
  problems.push_back(rounded_himmelblau());
  problems.push_back(inventory());
  problems.push_back(tandem_queue());
  return problems;
}

}  // namespace ricochet::held_out
