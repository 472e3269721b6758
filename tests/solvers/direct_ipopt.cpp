#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>

#include "tests/solvers/direct_calls.h"

namespace ricochet {
namespace {

constexpr Part both_constraints{static_cast<unsigned>(Part::equalities) |
                                static_cast<unsigned>(Part::inequalities)};

class ForIpopt : public Ipopt::TNLP {
 public:
  using Index = Ipopt::Index;
  using Number = Ipopt::Number;

  ForIpopt(const DirectCall& call, bool exact) : call_(call), exact_(exact) {}

  bool get_nlp_info(Index& n, Index& m, Index& slopes, Index& curves,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(problem().dimension());
    m = static_cast<Index>(problem().constraints);
    slopes = n * m;
    curves = exact_ ? n * (n + 1) / 2 : 0;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index m, Number* least,
                       Number* most) override {
    Eigen::Map<Vector>(lower, n) = problem().lower;
    Eigen::Map<Vector>(upper, n) = problem().upper;
    for (Index i = 0; i < m; ++i) least[i] = i < problem().equalities ? 0 : -2e19;
    std::fill_n(most, m, 0.0);
    return true;
  }
  bool get_starting_point(Index n, bool, Number* u, bool, Number*, Number*, Index, bool,
                          Number*) override {
    Eigen::Map<Vector>(u, n) = problem().start;
    return true;
  }
  bool eval_f(Index, const Number* u, bool, Number& told) override {
    told = call_.evaluator.values(call_.at(u), Part::objective)->objective;
    return true;
  }
  bool eval_grad_f(Index n, const Number* u, bool, Number* told) override {
    Eigen::Map<Vector>(told, n) =
        call_.evaluator.derivatives(call_.at(u), Part::objective)->gradient;
    return true;
  }
  bool eval_g(Index, const Number* u, bool, Index m, Number* told) override {
    Eigen::Map<Vector>(told, m) =
        call_.evaluator.values(call_.at(u), both_constraints)->constraints;
    return true;
  }
  bool eval_jac_g(Index n, const Number* u, bool, Index m, Index, Index* rows, Index* columns,
                  Number* told) override {
    if (told) {
      Eigen::Map<RowMajor>(told, m, n) =
          call_.evaluator.derivatives(call_.at(u), both_constraints)->jacobian;
      return true;
    }
    for (Index k = 0; k < n * m; ++k) rows[k] = k / n, columns[k] = k % n;
    return true;
  }
  bool eval_h(Index n, const Number* u, bool, Number factor, Index m, const Number* multipliers,
              bool, Index, Index* rows, Index* columns, Number* told) override {
    const Matrix curves = told ? *call_.evaluator.lagrangian_hessian(
                                     call_.at(u), factor, Eigen::Map<const Vector>(multipliers, m))
                               : Matrix();
    for (Index i = 0, k = 0; i < n; ++i) {
      for (Index j = 0; j <= i; ++j, ++k) {
        if (told) told[k] = curves(i, j);
        if (!told) rows[k] = i, columns[k] = j;
      }
    }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index, const Number* u, const Number*, const Number*,
                         Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    returned = call_.at(u);
  }

  Vector returned;

 private:
  const Problem& problem() const { return call_.problem; }

  const DirectCall& call_;
  bool exact_;
};

}  // namespace

Vector call_ipopt(const std::string& solver, const DirectCall& call) {
  const bool exact = solver == "ipopt-exact";
  const Ipopt::SmartPtr<ForIpopt> shown = new ForIpopt(call, exact);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  const auto options = application->Options();
  if (!exact) options->SetStringValue("hessian_approximation", "limited-memory");
  if (solver == "ipopt-tuned") {
    options->SetStringValue("mu_strategy", "monotone");
    options->SetNumericValue("mu_init", 1e-3);
    options->SetIntegerValue("limited_memory_max_history", 20);
  }
  options->SetNumericValue("constr_viol_tol", constraint_tolerance);
  options->SetNumericValue("acceptable_constr_viol_tol", constraint_tolerance);
  options->SetNumericValue("bound_relax_factor", 0);
  options->SetIntegerValue("max_iter", call.limit - 1);
  application->Initialize("");
  application->OptimizeTNLP(GetRawPtr(shown));
  return shown->returned;
}

}  // namespace ricochet
