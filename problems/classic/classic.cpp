#include "problems/classic/classic.h"

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/multimodal.h"
#include "problems/classic/plane.h"
#include "problems/classic/unimodal.h"

namespace ricochet::classic {

std::vector<Problem> classic_problems() {
  std::vector<Problem> problems = {
      sphere(5),          ellipsoid(5),      ellipsoid(20),    rosenbrock(2),
      rosenbrock(5),      rosenbrock(20),    zakharov(5),      dixon_price(5),
      schwefel_1_2(5),    powell_singular(), step(5),          rastrigin(2),
      rastrigin(5),       ackley(5),         griewank(5),      levy(5),
      styblinski_tang(5), schwefel_2_26(5),  hartmann_3(),     hartmann_6(),
      shekel(),           beale(),           booth(),          himmelblau(),
      goldstein_price(),  branin(),          six_hump_camel(),
  };
  const std::vector<Problem> constrained = hock_schittkowski_problems();
  problems.insert(problems.end(), constrained.begin(), constrained.end());
  return problems;
}

}  // namespace ricochet::classic
