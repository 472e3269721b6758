#include "problems/classic/hock_schittkowski.h"

#include <algorithm>
#include <string>
#include <utility>

namespace ricochet::classic {

std::vector<Problem> hock_schittkowski_problems() {
  std::vector<Problem> problems;
  for (const auto& part :
       {hock_schittkowski_valley(), hock_schittkowski_2(), hock_schittkowski_3(),
        hock_schittkowski_4(), hock_schittkowski_5(), hock_schittkowski_6(), hock_schittkowski_8(),
        hock_schittkowski_fits(), hock_schittkowski_plants(), hock_schittkowski_networks(),
        hock_schittkowski_dual(), hock_schittkowski_heat(), hock_schittkowski_geometric()}) {
    problems.insert(problems.end(), part.begin(), part.end());
  }
  const auto number = [](const Problem& problem) { return std::stoi(problem.name.substr(3)); };
  std::sort(problems.begin(), problems.end(),
            [number](const Problem& a, const Problem& b) { return number(a) < number(b); });
  return problems;
}

}  // namespace ricochet::classic
