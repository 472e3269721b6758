#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/random.h"

namespace ricochet {

/// The same problem in other coordinates and in another box, with the same best value. An advantage
/// of a solver from the origin, the middle or the ends of the box, or the start, is chance and
/// shows as spread over instances:
/// - The best point lies elsewhere in the box. The box shrinks to 0.5 to 1 of its width in every
///   coordinate and stays within the old one. If the problem is defined outside, too, the box keeps
///   its width, and the best point lies anywhere in its inner four fifths. A best point at an end
///   of the box stays there, unless the problem mirrors: then the box holds a part of the mirror
///   image, too, and the best point lies in its inner four fifths. If no best point is known, the
///   box does not change.
/// - Every coordinate is moved by up to the box's width and, with probability 1/2, reflected.
/// - A problem that allows it is rotated about its best point, so that the axes give no advantage.
/// - The start is drawn uniformly from the box, or is the image of the published one, which the box
///   then contains.
///
/// Instance 0 is the problem as stated. Deterministic in (problem name, number). Throws
/// std::invalid_argument for number < 0.
Problem instance(const Problem& problem, int number);

/// The point of the problem as stated that x is in the instance with this number >= 0. In the box,
/// unless the problem rotates.
Vector stated_point(const Problem& problem, int number, const Vector& x);

/// Whether one of the shell patterns chooses the problem: see Problem::hazardous.
bool is_chosen(const Problem& problem, const std::vector<std::string>& patterns);

/// A point uniform in the problem's box.
Vector uniform_point(const Problem& problem, Random& random);

/// A seed that depends on the identity of a run, not on when or where it executes: a 64-bit FNV-1a
/// hash of the names and numbers, each closed by a separator. `shown`, unless empty, distinguishes
/// the formulations of the same problem.
std::uint64_t seed_of(std::string_view problem, std::string_view solver, int instance, int run,
                      std::string_view shown = {});

/// The 64-bit hash FNV-1a with its published offset basis and prime. Source: Fowler, Noll, Vo,
/// Eastlake, The FNV Non-Cryptographic Hash Algorithm, RFC 9923.
class FnvHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) {
      value_ = (value_ ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    }
  }

  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Version of the suite: problems, names and seeds. Stores, best values and fits of another version
/// are refused.
inline constexpr int suite_version = 3;

/// Results of a search for a problem's values, by name; empty if no point is feasible.
using Findings = std::map<std::string, double>;

/// A problem whose best value, and possibly other values, is not known yet. A campaign searches for
/// them at its start and keeps the findings in its store.
struct SearchedProblem {
  std::string family;
  Problem problem;  ///< name, box and formulations; its values may be wrong
  std::function<Findings()> search;
  std::function<Problem(const Findings&)>
      with;  ///< the complete problem; findings must not be empty
};

}  // namespace ricochet
