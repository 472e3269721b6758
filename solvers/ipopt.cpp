#include <fmt/format.h>
#include <unistd.h>

#include <IpCompoundVector.hpp>
#include <IpIpoptApplication.hpp>
#include <IpIpoptCalculatedQuantities.hpp>
#include <IpIpoptData.hpp>
#include <IpOrigIpoptNLP.hpp>
#include <IpRegOptions.hpp>
#include <IpTNLP.hpp>
#include <IpTNLPAdapter.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>

#include "solvers/library_solvers.h"
#include "solvers/scaled_box.h"
#include "src/core/child_process.h"

namespace ricochet {

namespace {

using Ipopt::Index;
using Ipopt::Number;

/// Thrown through Ipopt once the evaluator refuses. If an evaluation only fails, Ipopt halves its
/// step and, in the end, enters its restoration phase; an unknown exception it turns into a return
/// status.
struct Refused {};

/// Ipopt asks for both kinds of constraints at once.
constexpr Part constraints_only{static_cast<unsigned>(Part::equalities) |
                                static_cast<unsigned>(Part::inequalities)};

constexpr const char* tuned_strategy = "monotone";
constexpr double tuned_barrier = 1e-3;  // the initial value
constexpr int tuned_history = 20;       // steps that the limited-memory Hessian rests on

/// Where second derivatives come from.
enum class Hessian {
  limited_memory,  ///< Ipopt's own estimate, from gradients
  exact            ///< from the problem
};

/// A problem with Ipopt's interface. The Jacobian is dense and row-major. An
/// evaluation fails where a number is not finite: Ipopt then halves its step or, where it needs
/// derivatives or starts, ends with Invalid_Number_Detected.
class ScaledProblem : public Ipopt::TNLP {
 public:
  ScaledProblem(Evaluator& evaluator, const Vector& start, Hessian hessian, Coordinates coordinates)
      : box_(evaluator, coordinates),
        start_(box_.to_scaled(start)),
        constraints_(evaluator.constraints()),
        equalities_(evaluator.equalities()),
        hessian_(hessian) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian_entries, Index& hessian_entries,
                    IndexStyleEnum& index_style) override {
    n = static_cast<Index>(start_.size());
    m = static_cast<Index>(constraints_);
    jacobian_entries = n * m;
    hessian_entries = hessian_ == Hessian::exact ? n * (n + 1) / 2 : 0;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* u_lower, Number* u_upper, Index m, Number* c_lower,
                       Number* c_upper) override {
    std::copy_n(box_.lower().data(), n, u_lower);
    std::copy_n(box_.upper().data(), n, u_upper);
    const auto equalities = static_cast<Index>(equalities_);
    std::fill_n(c_lower, equalities, 0.0);
    std::fill_n(c_lower + equalities, m - equalities, -2e19);  // beyond 1e19: no bound
    std::fill_n(c_upper, m, 0.0);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* u, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy_n(start_.data(), n, u);
    return true;
  }

  bool eval_f(Index n, const Number* u, bool, Number& objective) override {
    const auto values = box_.values(Eigen::Map<const Vector>(u, n), Part::objective);
    const bool finite = values && std::isfinite(values->objective);
    if (finite) objective = values->objective;
    return done(finite);
  }

  bool eval_grad_f(Index n, const Number* u, bool, Number* gradient) override {
    const auto derivatives = box_.derivatives(Eigen::Map<const Vector>(u, n), Part::objective);
    const bool finite = derivatives && derivatives->gradient.allFinite();
    if (finite) Eigen::Map<Vector>(gradient, n) = derivatives->gradient;
    return done(finite);
  }

  bool eval_g(Index n, const Number* u, bool, Index m, Number* constraints) override {
    const auto values = box_.values(Eigen::Map<const Vector>(u, n), constraints_only);
    const bool finite = values && values->constraints.allFinite();
    if (finite) Eigen::Map<Vector>(constraints, m) = values->constraints;
    return done(finite);
  }

  bool eval_jac_g(Index n, const Number* u, bool, Index m, Index, Index* rows, Index* columns,
                  Number* entries) override {
    if (!entries) {  // Ipopt asks for the structure
      for (Index k = 0; k < n * m; ++k) {
        rows[k] = k / n;
        columns[k] = k % n;
      }
      return true;
    }
    const auto derivatives = box_.derivatives(Eigen::Map<const Vector>(u, n), constraints_only);
    // NOTE: Ipopt does not look at these numbers, and MUMPS 5.5 reads beyond its memory where one
    // of its matrix is not finite.
    const bool finite = derivatives && derivatives->jacobian.allFinite();
    if (finite) Eigen::Map<Matrix>(entries, n, m) = derivatives->jacobian.transpose();
    return done(finite);
  }

  bool eval_h(Index n, const Number* u, bool, Number objective_factor, Index m,
              const Number* multipliers, bool, Index, Index* rows, Index* columns,
              Number* entries) override {
    if (!entries) {  // Ipopt asks for the structure: the lower triangle
      for (Index i = 0, k = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j, ++k) {
          rows[k] = i;
          columns[k] = j;
        }
      }
      return true;
    }
    const auto hessian = box_.lagrangian_hessian(Eigen::Map<const Vector>(u, n), objective_factor,
                                                 Eigen::Map<const Vector>(multipliers, m));
    const bool finite = hessian && hessian->allFinite();
    if (finite) {
      for (Index i = 0, k = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j, ++k) entries[k] = (*hessian)(i, j);
      }
    }
    return done(finite);
  }

  /// Keeps the iterate, which is what Ipopt returns where `max_iter` ends it here: if it is stopped
  /// within a step, it tells none. While feasibility is restored, it has more variables than ours.
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Index, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData* data,
                             Ipopt::IpoptCalculatedQuantities* quantities) override {
    if (mode == Ipopt::RegularMode) {
      auto* const scaled = dynamic_cast<Ipopt::OrigIpoptNLP*>(GetRawPtr(quantities->GetIpoptNLP()));
      scaled_ = scaled;
    }
    Ipopt::SmartPtr<const Ipopt::Vector> iterate = data->curr()->x();
    if (mode == Ipopt::RestorationPhaseMode) {
      iterate = dynamic_cast<const Ipopt::CompoundVector&>(*iterate).GetComp(0);
    }
    iterate = scaled_->NLP_scaling()->unapply_vector_scaling_x(iterate);
    Vector u(start_.size());
    dynamic_cast<Ipopt::TNLPAdapter&>(*scaled_->nlp()).ResortX(*iterate, u.data());
    final_ = box_.from_scaled(u);
    return !box_.over();
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* u, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    if (box_.over()) return;  // a step that it has not finished
    const Vector last = Eigen::Map<const Vector>(u, n);
    if (last.allFinite()) final_ = box_.from_scaled(last);
  }

  /// The last iterate of Ipopt; nothing if there is none.
  const std::optional<Vector>& final_point() const { return final_; }

 private:
  bool done(bool answered) const {
    if (box_.over()) throw Refused();
    return answered;
  }

  ScaledBox box_;
  Vector start_;
  Eigen::Index constraints_, equalities_;
  Hessian hessian_;
  std::optional<Vector> final_;
  Ipopt::OrigIpoptNLP* scaled_ = nullptr;  // Ipopt's own view of this problem
};

std::string in_words(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "solved";
    case Ipopt::Solved_To_Acceptable_Level:
      return "solved to an acceptable level";
    case Ipopt::Infeasible_Problem_Detected:
      return "infeasible problem detected";
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return "search direction too small";
    case Ipopt::Diverging_Iterates:
      return "diverging";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "iterations spent";
    case Ipopt::Restoration_Failed:
      return "restoration failed";
    case Ipopt::Error_In_Step_Computation:
      return "no step found";
    case Ipopt::Invalid_Number_Detected:
      return not_finite;
    default:
      return "failure";
  }
}

/// Guards every use of Ipopt, including construction and destruction: it and MUMPS keep global
/// state.
std::mutex ipopt_mutex;

void give(Ipopt::IpoptApplication& application, const GivenOptions& given) {
  for (const auto& [name, value] : given) {
    if (const auto* word = std::get_if<std::string>(&value)) {
      application.Options()->SetStringValue(name, *word);
      continue;
    }
    const double number = std::get<double>(value);
    if (application.RegOptions()->GetOption(name)->Type() == Ipopt::OT_Integer) {
      application.Options()->SetIntegerValue(name, static_cast<Index>(number));
    } else {
      application.Options()->SetNumericValue(name, number);
    }
  }
}

struct Choice {
  const char* name;
  Settings settings;
  Hessian hessian;
  Coordinates coordinates = Coordinates::own;
};

constexpr Choice own_choice{"ipopt", Settings::own, Hessian::limited_memory};
constexpr Choice tuned_choice{"ipopt-tuned", Settings::tuned, Hessian::limited_memory};
constexpr Choice exact_choice{"ipopt-exact", Settings::own, Hessian::exact};

/// Solves with a new Ipopt. The caller holds the mutex.
Ipopt::ApplicationReturnStatus solve(const Ipopt::SmartPtr<ScaledProblem>& problem,
                                     const Choice& choice, const GivenOptions& given) {
  // false: no console, so no banner and no log.
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  const auto options = application->Options();
  if (choice.hessian == Hessian::limited_memory) {
    options->SetStringValue("hessian_approximation", "limited-memory");
  }
  if (choice.settings == Settings::tuned) {
    // Without second derivatives Ipopt adapts its barrier freely. It then often fails on a
    // constraint as curved as that of a surrogate. Also, a start may be near the optimum.
    options->SetStringValue("mu_strategy", tuned_strategy);
    options->SetNumericValue("mu_init", tuned_barrier);
    options->SetIntegerValue("limited_memory_max_history", tuned_history);
  }
  // What Ipopt calls solved, even to an acceptable level, must be feasible to the score. Its own
  // tolerances are 1e-4 and 1e-2.
  options->SetNumericValue("constr_viol_tol", constraint_tolerance);
  options->SetNumericValue("acceptable_constr_viol_tol", constraint_tolerance);
  // The evaluator knows no points outside the box, so Ipopt must not widen the bounds.
  options->SetNumericValue("bound_relax_factor", 0.0);
  give(*application, given);
  // "": no options file, not even one in the working directory.
  const Ipopt::ApplicationReturnStatus status = application->Initialize("");
  return status == Ipopt::Solve_Succeeded ? application->OptimizeTNLP(GetRawPtr(problem)) : status;
}

SolverTermination minimise(Evaluator& evaluator, const Vector& start, const Choice& choice,
                           const GivenOptions& given) {
  const std::lock_guard lock(ipopt_mutex);
  const Ipopt::SmartPtr<ScaledProblem> problem =
      new ScaledProblem(evaluator, start, choice.hessian, choice.coordinates);
  const Ipopt::ApplicationReturnStatus status = solve(problem, choice, given);
  return {evaluator.over() ? stopped_by_evaluator : in_words(status), problem->final_point()};
}

Solver made(const Choice& choice, const GivenOptions& given) {
  Solver solver;
  solver.name = choice.name;
  solver.version = "Ipopt " IPOPT_VERSION " (adapter 3)";
  solver.capabilities =
      choice.hessian == Hessian::exact ? ipopt_exact_capabilities : ipopt_capabilities;
  solver.at_limit = AtLimit::own_point;
  solver.solve = [choice, given](Evaluator& evaluator, const Vector& start, Random&) {
    return minimise(evaluator, start, choice, given);
  };
  return solver;
}

/// The shortest vector (x, y) with x + y <= -1, within [-2, 2]^2.
Problem tiny_problem() {
  Problem problem;
  problem.name = "tiny";
  problem.lower = Vector::Constant(2, -2);
  problem.upper = problem.start = Vector::Constant(2, 2);
  problem.constraints = 1;
  problem.evaluate = [](const Vector& x) {
    return Values{x.squaredNorm(), Vector::Constant(1, x.sum() + 1)};
  };
  problem.differentiate = [evaluate = problem.evaluate](const Vector& x) {
    return Derivatives{evaluate(x), 2 * x, Matrix::Ones(1, 2)};
  };
  problem.lagrangian_hessian = [](const Vector&, double factor, const Vector&) -> Matrix {
    return 2 * factor * Matrix::Identity(2, 2);
  };
  return problem;
}

/// Returns true if this build of Ipopt can use the options, whether it solves with them or not. The
/// caller holds the mutex.
bool takes(const Choice& choice, const GivenOptions& given) {
  const Problem problem = tiny_problem();
  Evaluator evaluator(problem, {1000});
  const Ipopt::SmartPtr<ScaledProblem> posed =
      new ScaledProblem(evaluator, problem.start, choice.hessian, choice.coordinates);
  const Ipopt::ApplicationReturnStatus status = solve(posed, choice, given);
  return evaluator.over() ||
         (status != Ipopt::Invalid_Option && status != Ipopt::Unrecoverable_Exception &&
          status != Ipopt::NonIpopt_Exception_Thrown);
}

/// The same in a process of its own, since Ipopt ends the process where it lacks a routine.
bool is_usable(const Choice& choice, const GivenOptions& given) {
  constexpr std::chrono::seconds patience{30};
  constexpr double megabytes = 2000;
  const std::lock_guard lock(ipopt_mutex);
  const auto answer = [&] {
    std::atexit([] { _exit(1); });  // without the parent's exit handlers
    return std::string(takes(choice, given) ? "usable" : "");
  };
  try {
    return !called_in_isolation(answer, patience, megabytes).empty();
  } catch (const std::system_error&) {  // no process can be started
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Throws std::invalid_argument for options that Ipopt lists, but this build of it cannot use, such
/// as a linear solver that it lacks.
void check_usable(const Choice& choice, const GivenOptions& given) {
  if (given.empty() || is_usable(choice, given)) return;
  for (const auto& [name, value] : given) {
    if (is_usable(choice, {{name, value}})) continue;
    throw std::invalid_argument(
        fmt::format("{} = {}: this build of Ipopt cannot use it", name, text_of(value)));
  }
  throw std::invalid_argument("this build of Ipopt cannot use these options together");
}

/// Options that the adapter sets itself, that write files or print, or that depend on the clock.
bool is_kept_back(const std::string& name) {
  static const std::set<std::string> kept = {
      "hessian_approximation", "output_file",
      "option_file_name",      "file_print_level",
      "print_level",           "print_user_options",
      "max_cpu_time",          "print_options_documentation"};
  return kept.contains(name);
}

SolverOption option_of(const Ipopt::RegisteredOption& known) {
  SolverOption option;
  option.name = known.Name();
  if (known.Type() == Ipopt::OT_String) {
    for (const auto& entry : known.GetValidStrings()) option.words.push_back(entry.value_);
    option.usual = known.DefaultString();
    return option;
  }
  Range& range = option.range;
  range.whole = known.Type() == Ipopt::OT_Integer;
  const auto end = [&](bool there, auto bound, double otherwise) {
    return there ? static_cast<double>(bound()) : otherwise;
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double largest = range.whole ? std::numeric_limits<Index>::max() : infinity;
  range.least = end(
      known.HasLower(),
      [&]() -> double { return range.whole ? known.LowerInteger() : known.LowerNumber(); },
      -largest);
  range.most = end(
      known.HasUpper(),
      [&]() -> double { return range.whole ? known.UpperInteger() : known.UpperNumber(); },
      largest);
  range.without_least = !range.whole && known.HasLower() && known.LowerStrict();
  range.without_most = !range.whole && known.HasUpper() && known.UpperStrict();
  option.usual = range.whole ? std::to_string(known.DefaultInteger())
                             : text_of(OptionValue(known.DefaultNumber()));
  return option;
}

/// All options that Ipopt lists, except those kept back.
std::vector<SolverOption> known_options() {
  const std::lock_guard lock(ipopt_mutex);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  std::vector<SolverOption> options;
  for (const auto& [name, option] : application->RegOptions()->RegisteredOptionsList()) {
    if (!is_kept_back(name)) options.push_back(option_of(*option));
  }
  return options;
}

/// Replaces the default of an option that the adapter sets differently from Ipopt.
void tell_own(std::vector<SolverOption>& options, const std::string& name,
              const std::string& usual) {
  for (SolverOption& option : options) {
    if (option.name == name) option.usual = usual;
  }
}

}  // namespace

Solver ipopt(Settings settings) {
  return made(settings == Settings::tuned ? tuned_choice : own_choice, {});
}

Solver ipopt_exact() {
  return made(exact_choice, {});
}

std::vector<AdjustableSolver> adjustable_ipopt() {
  std::vector<SolverOption> options = known_options();
  const Coordinates usual = own_choice.coordinates;
  options.push_back({std::string(coordinates_option.key),
                     usual_of(coordinates_option, usual),
                     {},
                     words_of(usual)});
  tell_own(options, "bound_relax_factor", "0");
  for (const char* name : {"constr_viol_tol", "acceptable_constr_viol_tol"}) {
    tell_own(options, name, text_of(OptionValue(constraint_tolerance)));
  }
  std::vector<AdjustableSolver> solvers;
  for (const Choice& choice : {own_choice, exact_choice, tuned_choice}) {
    // With a limited-memory Hessian Ipopt changes its own default.
    tell_own(options, "mu_strategy", choice.hessian == Hessian::exact ? "monotone" : "adaptive");
    if (choice.settings == Settings::tuned) {
      tell_own(options, "mu_strategy", tuned_strategy);
      tell_own(options, "mu_init", text_of(OptionValue(tuned_barrier)));
      tell_own(options, "limited_memory_max_history", std::to_string(tuned_history));
    }
    solvers.push_back({choice.name, options, [own = choice](GivenOptions given) {
                         Choice chosen = own;
                         const auto coordinates =
                             given.extract(std::string(coordinates_option.key));
                         if (coordinates) give(coordinates.mapped(), chosen.coordinates);
                         check_usable(chosen, given);
                         return made(chosen, given);
                       }});
  }
  return solvers;
}

}  // namespace ricochet
