#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/families.h"
#include "src/core/instance.h"
#include "src/core/near_names.h"
#include "src/interface/last_error.h"
#include "src/interface/opened_problem.h"
#include "src/research/suite/families.h"

/// The functions that ricochet.h declares for external programs.
namespace ricochet::interface {
namespace {

/// Every problem, made at the first call in about a tenth of a second. Never destroyed: a program
/// may close its problems while it ends.
const std::vector<Problem>& problems() {
  static const auto& all = *new const std::vector<Problem>(every_problem(suite_families()));
  return all;
}

/// Throws InputError if there is no problem of this name.
Problem problem_named(const std::string& name, const std::vector<Problem>& among) {
  std::vector<std::string> known;
  for (const Problem& problem : among) {
    if (problem.name == name) return problem;
    known.push_back(problem.name);
  }
  throw InputError(fmt::format("{}: there is no such problem; {}", name,
                               what_instead(name, known, "`ricochet list problems`")));
}

/// All open problems; detects a pointer that is not one of them.
class OpenProblems {
 public:
  ricochet_problem* add(std::unique_ptr<OpenedProblem> problem) {
    ricochet_problem* const shown = problem.get();
    const std::lock_guard lock(mutex_);
    problems_.emplace(shown, std::move(problem));
    return shown;
  }

  /// Throws InputError if it is not open.
  const OpenedProblem& at(const ricochet_problem* shown) {
    const std::lock_guard lock(mutex_);
    return *found(shown)->second;
  }

  /// Throws InputError if it is not open.
  void close(const ricochet_problem* shown) {
    std::unique_ptr<OpenedProblem> closed;  // destroyed after the lock is released
    const std::lock_guard lock(mutex_);
    const auto problem = found(shown);
    closed = std::move(problem->second);
    problems_.erase(problem);
  }

 private:
  using Problems = std::unordered_map<const ricochet_problem*, std::unique_ptr<OpenedProblem>>;

  Problems::iterator found(const ricochet_problem* shown) {
    const auto problem = problems_.find(shown);
    if (problem == problems_.end()) throw InputError("the problem is not open");
    return problem;
  }

  std::mutex mutex_;
  Problems problems_;
};

OpenProblems& open_problems() {
  static auto& all = *new OpenProblems;  // never destroyed, like the problems
  return all;
}

/// `scene`: a machine file, whose problems are meant; NULL for those of the suite.
ricochet_problem* open(const char* scene, const char* name, const char* formulation,
                       std::int32_t number, std::int64_t budget, std::uint64_t seed) {
  if (!name) throw InputError("the name of the problem is NULL");
  const Problem problem = scene ? problem_named(name, every_problem(suite_families(scene)))
                                : problem_named(name, problems());
  const Formulation shown = problem.formulation_named(formulation ? formulation : "");
  if (number < 0) throw InputError(fmt::format("instance {}: must be >= 0", number));
  if (budget < 1) throw InputError(fmt::format("budget {}: must be >= 1", budget));
  return open_problems().add(
      std::make_unique<OpenedProblem>(instance(problem.formulated(shown), number), budget, seed));
}

}  // namespace
}  // namespace ricochet::interface

using namespace ricochet::interface;

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED ricochet_problem* ricochet_open(const char* problem, const char* formulation,
                                         std::int32_t instance, std::int64_t budget,
                                         std::uint64_t seed) {
  ricochet_problem* opened = nullptr;
  succeeds([&] { opened = open(nullptr, problem, formulation, instance, budget, seed); });
  return opened;
}

EXPORTED ricochet_problem* ricochet_open_scene(const char* scene, const char* problem,
                                               const char* formulation, std::int32_t instance,
                                               std::int64_t budget, std::uint64_t seed) {
  ricochet_problem* opened = nullptr;
  succeeds([&] {
    if (!scene || !*scene) throw ricochet::InputError("the machine file has no name");
    opened = open(scene, problem, formulation, instance, budget, seed);
  });
  return opened;
}

EXPORTED void ricochet_close(ricochet_problem* problem) {
  if (problem) succeeds([&] { open_problems().close(problem); });
}

EXPORTED std::int32_t ricochet_judge(ricochet_problem* problem, const double* x, double* objective,
                                     double* violation) {
  const bool done = succeeds([&] {
    const ricochet::TrueValues true_values = open_problems().at(problem).judge(x);
    if (objective) *objective = true_values.objective;
    if (violation) *violation = true_values.violation;
  });
  return done ? 0 : 1;
}

EXPORTED const char* ricochet_problem_name(std::int32_t index) {
  const char* name = nullptr;
  succeeds([&] {
    const auto& all = problems();
    if (index < 0 || static_cast<std::size_t>(index) >= all.size()) return;
    name = all[static_cast<std::size_t>(index)].name.c_str();
  });
  return name;
}

EXPORTED const char* ricochet_error(void) {
  return last_error();
}
