#pragma once

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/experiment/campaign.h"
#include "src/experiment/plan.h"
#include "src/experiment/store.h"
#include "tests/support/numbers.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

/// Made-up problems, solvers, plans and campaigns, and runs with anything that a store must keep.
namespace ricochet {

/// The sum of (x_i - 0.3)^2; with one constraint, x_0 <= 1/2, where wanted.
inline Problem bowl(const std::string& name, Eigen::Index n, bool constrained = false) {
  Problem problem = box_problem(name, n, 0, 1, 0.9, [](const Vector&) { return 0.0; });
  problem.source = "sum of (x_i - 0.3)^2";
  problem.best_known = 0.0;
  problem.best_point = Vector::Constant(n, 0.3);
  problem.constraints = constrained ? 1 : 0;
  problem.evaluate = [constrained](const Vector& x) {
    return Values{(x.array() - 0.3).square().sum(),
                  constrained ? Vector(Vector::Constant(1, x[0] - 0.5)) : Vector()};
  };
  problem.cost = static_cast<double>(n);
  problem.gradient_cost = 3;
  return problem;
}

/// The same, smoothed in name.
inline Problem smooth_bowl(const std::string& name, bool constrained) {
  Problem problem = with_idle_knob(bowl(name, 2, constrained));
  problem.smoothing = 0.5;
  return problem;
}

/// Asks for uniform points until the budget is spent. Takes no constraints.
inline Solver chance(const std::string& name) {
  Solver solver;
  solver.name = name;
  solver.version = "1";
  solver.stochastic = true;
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random& random) {
    Vector x = start;
    while (evaluator.objective(x)) x = uniform_point(evaluator.lower(), evaluator.upper(), random);
    return SolverTermination{"spent"};
  };
  return solver;
}

/// A problem whose best point is not known before it is searched, which is counted where wanted.
inline SearchedProblem searched(const Problem& known, const std::shared_ptr<int>& searches) {
  Problem open = known;
  open.best_known.reset();
  open.best_point.reset();
  return {"bowl", open,
          [=] {
            if (searches) ++*searches;
            return Findings{{"best_point", (*known.best_point)[0]}};
          },
          [=](const Findings&) { return known; }};
}

/// Bowls, one for each level of the restitution that a plan names. Of machines around "nowhere"
/// only those below 1 are feasible.
inline std::vector<SearchedProblem> bowls_of(const MachineGrid& grid,
                                             const std::shared_ptr<int>& searches = nullptr) {
  std::vector<SearchedProblem> problems;
  const auto levels = grid.levels.find("restitution");
  if (levels == grid.levels.end()) return problems;
  for (const OptionValue& level : levels->second) {
    const auto r = std::get<double>(level);
    const std::string name = "bowl-" + grid.around + "-" + std::to_string(r);
    problems.push_back(searched(bowl(name, 1), searches));
    if (grid.around != "nowhere" || r < 1) continue;
    problems.back().search = [search = problems.back().search] { return search(), Findings(); };
  }
  return problems;
}

inline Catalogue made_up_catalogue() {
  Catalogue catalogue;
  Problem open = bowl("bowl-open", 1);
  open.best_known.reset();
  catalogue.families = {
      {"bowl", {bowl("bowl-1", 1), bowl("bowl-2", 2), bowl("bowl-8", 8), open}},
      {"cup",
       {bowl("cup-2", 2, true), smooth_bowl("cup-smooth", true), smooth_bowl("cup-s", false)}}};
  catalogue.solvers = {chance("chance-a"), chance("chance-b"), chance("luck")};
  catalogue.own_solver = [](const std::string& text) -> std::optional<Solver> {
    if (text.find('/') == std::string::npos) return std::nullopt;
    return chance(text.substr(text.rfind('/') + 1));
  };
  catalogue.varied_solver = [](const VariedSolver& varied) {
    if (varied.of != "luck") throw InputError(varied.of + " has no options");
    return chance(varied.name);
  };
  catalogue.grid_keys = {{"restitution", {}},
                         {"friction", {}},
                         {"disturbance", {}},
                         {"fidelity", {"impact", "compliant", "planar"}}};
  catalogue.grid_problems = [](const MachineGrid& grid) {
    if (grid.around == "C99") throw InputError("there is no case C99");
    return bowls_of(grid);
  };
  return catalogue;
}

/// The same, that counts searches.
inline Catalogue searched_catalogue(const std::shared_ptr<int>& searches) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.grid_problems = [searches](const MachineGrid& grid) {
    return bowls_of(grid, searches);
  };
  catalogue.drawn_problem = [searches](const Problem& problem,
                                       int number) -> std::optional<SearchedProblem> {
    if (problem.dimension() > 1) return std::nullopt;
    return searched(bowl(problem.name + "~" + std::to_string(number), 1), searches);
  };
  return catalogue;
}

/// A part of a plan with what it cannot do without, unless the rest has it.
inline std::string part_of(const std::string& problems, const std::string& rest = "") {
  return "[[part]]\nproblems = " + problems +
         (rest.find("solvers") == std::string::npos ? "\nsolvers = \"chance-a\"" : "") +
         (rest.find("budgets") == std::string::npos ? "\nbudgets = 10" : "") + "\n" + rest + "\n";
}

inline Campaign made_up_campaign(const std::string& plan,
                                 const Catalogue& catalogue = made_up_catalogue()) {
  return {plan_from(plan, "test"), catalogue};
}

inline CampaignDescription a_description() {
  CampaignDescription description;
  description.plan = "solvers = [\"fast\"]\n";
  description.problems = {
      {"quiet", "speed", "C1", 1, 2, 1, 1e-6, -0.0, {{"friction", 0.25}}, {{"best_point", 0.1}}},
      {"valley", "classic", "", 2, 0, 0, 0, 1e300, {}, {}}};
  description.solvers = {{"slow", "2.1"}, {"fast", ""}};
  description.program = {{"version", "0.1.0"}, {"compiler", "GCC 12.2"}};
  description.made = {{"date", "2026-01-02"}, {"cores", "2"}};
  return description;
}

/// The key of a run of that campaign; another one for every number.
inline RunKey a_key(int number) {
  return {{number % 2 == 0 ? "valley" : "quiet", "count", "plain",
           number % 3 == 0 ? "slow" : "fast", number % 5 == 0 ? 1000 : 20, "n"},
          number % 7,
          number / 7};
}

/// Draws of what a store must keep.
namespace any {

/// Any bits that a number can have, and often those that are lost first.
inline double number(std::mt19937_64& random) {
  const double lost_first[] = {0.0,       -0.0, infinity, -infinity, std::nan(""), -std::nan("7"),
                               -0x1.p+63, 1e18, 3.0,      5e-324};
  const std::uint64_t bits = random();
  return bits % 2 == 0 ? lost_first[random() % std::size(lost_first)] : std::bit_cast<double>(bits);
}

inline std::int64_t count(std::mt19937_64& random) {
  return static_cast<std::int64_t>(random() >> (1 + random() % 63));
}

inline double time(std::mt19937_64& random) {
  const double seconds = number(random);
  return std::isfinite(seconds) && !std::signbit(seconds) ? seconds : 0.25;
}

inline Vector point(std::mt19937_64& random) {
  Vector x(static_cast<Eigen::Index>(random() % 5));
  for (double& coordinate : x) coordinate = number(random);
  return x;
}

inline TrueValues true_values(std::mt19937_64& random) {
  const double objective = number(random);
  return {objective, std::abs(number(random))};
}

/// A trace in which every step improves the one before.
inline std::vector<Improvement> trace(std::mt19937_64& random, std::int64_t charged) {
  std::vector<Improvement> trace;
  for (auto left = random() % 4; left > 0; --left) {
    const auto evaluations =
        static_cast<std::int64_t>(random() % (static_cast<std::uint64_t>(charged) + 1));
    const TrueValues reached = true_values(random);
    if (std::isnan(reached.objective) || std::isnan(reached.violation)) continue;
    trace.push_back({evaluations, time(random), reached, point(random)});
  }
  std::ranges::sort(trace, [](const Improvement& a, const Improvement& b) {
    return better(b.true_values, a.true_values);
  });
  for (std::size_t k = 1; k < trace.size(); ++k) {
    trace[k].evaluations = std::max(trace[k].evaluations, trace[k - 1].evaluations);
    trace[k].seconds = std::max(trace[k].seconds, trace[k - 1].seconds);
  }
  return trace;
}

inline std::string text(std::mt19937_64& random) {
  std::string text(random() % 6, ' ');
  for (char& c : text) c = "a'\"\\\n;\0\xFF"[random() % 8];
  return text;
}

/// Any record that a run may have.
inline RunRecord record(std::mt19937_64& random) {
  RunRecord record;
  record.problem = text(random);
  record.solver = text(random);
  record.instance = static_cast<int>(random() >> 33);
  record.run = static_cast<int>(random() >> 33);
  record.seed = random();
  record.budget = {count(random), random() % 2 == 0 ? infinity : time(random)};
  const std::int64_t charged = count(random) % std::max<std::int64_t>(1, record.budget.evaluations);
  record.ledger = {count(random), count(random), count(random),
                   charged,       count(random), time(random)};
  record.termination_reason = static_cast<TerminationReason>(random() % 6);
  for (auto left = random() % 20; left > 0; --left) {
    record.terminations.push_back({random() % 3 == 0 ? text(random) : "again", point(random)});
  }
  if (random() % 2 == 0) record.returned = ReturnedPoint{point(random), true_values(random)};
  record.failure = text(random);
  record.trace = trace(random, charged);
  return record;
}

}  // namespace any

// Every bit of a record as texts, to be compared.

inline std::string bits_of(double number) {
  return fmt::format("{} = {:016x} ", std::isnan(number) ? std::abs(number) : number,
                     std::bit_cast<std::uint64_t>(number));
}
inline std::string bits_of(const TrueValues& values, const Vector& x) {
  std::string bits = bits_of(values.objective) + bits_of(values.violation) + "at ";
  for (const double coordinate : x) bits += bits_of(coordinate);
  return bits;
}
inline std::string bits_of(const Improvement& step) {
  return fmt::format("{} {}{}", step.evaluations, bits_of(step.seconds),
                     bits_of(step.true_values, step.x));
}

inline std::vector<std::string> bits_of(const RunRecord& r) {
  const Ledger& asked = r.ledger;
  std::vector<std::string> bits = {
      r.problem,
      r.solver,
      fmt::format("instance {}, run {}, seed {}", r.instance, r.run, r.seed),
      fmt::format("of {} {}at {}", r.budget.evaluations, bits_of(r.budget.seconds),
                  r.budget.gradient_price.value_or(-1)),
      fmt::format("ledger {} {} {} {} {} {}", asked.values, asked.derivatives, asked.hessians,
                  asked.charged, asked.refused, bits_of(asked.seconds)),
      fmt::format("ended by {} {}", static_cast<int>(r.termination_reason), r.failure)};
  for (const SolverTermination& end : r.terminations) {
    bits.push_back(end.reason + (end.point ? bits_of(TrueValues{}, *end.point) : ""));
  }
  if (r.returned) bits.push_back(bits_of(r.returned->true_values, r.returned->x));
  for (const Improvement& step : r.trace) bits.push_back(bits_of(step));
  return bits;
}

/// Without the times, which are others in every run.
inline RunRecord without_times(RunRecord record) {
  record.ledger.seconds = 0;
  for (Improvement& step : record.trace) step.seconds = 0;
  return record;
}

/// What a store keeps of a record: of the trace's points the last, and none of the starts'.
inline RunRecord kept_of(RunRecord record) {
  for (SolverTermination& end : record.terminations) end.point.reset();
  for (std::size_t k = 0; k + 1 < record.trace.size(); ++k) record.trace[k].x = Vector();
  return record;
}

}  // namespace ricochet
