#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "problems/families.h"
#include "src/core/error.h"
#include "src/core/instance.h"
#include "src/core/near_names.h"
#include "src/interface/last_error.h"
#include "src/interface/opened_problem.h"

/// The functions that ricochet.h declares for programs outside.
namespace ricochet::interface {
namespace {

/// Every question, made when the first is asked for: in about a tenth of a second. Never
/// destroyed: a program may close its problems while it ends.
const std::vector<Question>& questions() {
  static const auto& all = *new const std::vector<Question>(every_question(all_families()));
  return all;
}

/// Throws InputError where there is none of this name.
const Question& question_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Question& question : questions()) {
    if (question.name() == name) return question;
    known.push_back(question.name());
  }
  throw InputError(
      fmt::format("{}: there is no such question; {}", name, what_instead(name, known)));
}

/// All problems that are open, so that one that is not is told apart.
class OpenProblems {
 public:
  ricochet_problem* add(std::unique_ptr<OpenedProblem> problem) {
    ricochet_problem* const shown = problem.get();
    const std::lock_guard lock(mutex_);
    problems_.emplace(shown, std::move(problem));
    return shown;
  }

  /// Throws InputError where it is not open.
  const OpenedProblem& at(const ricochet_problem* shown) {
    const std::lock_guard lock(mutex_);
    return *found(shown)->second;
  }

  /// Throws InputError where it is not open.
  void close(const ricochet_problem* shown) {
    std::unique_ptr<OpenedProblem> closed;  // destroyed when others may go on
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
  static auto& all = *new OpenProblems;  // never destroyed, as the questions
  return all;
}

ricochet_problem* open(const char* name, const char* form, std::int32_t number, std::int64_t budget,
                       std::uint64_t seed) {
  if (!name) throw InputError("the name of the question is NULL");
  const Question& question = question_named(name);
  const Form shown = question.form_named(form ? form : "");
  if (number < 0) throw InputError(fmt::format("instance {}: must be >= 0", number));
  if (budget < 1) throw InputError(fmt::format("budget {}: must be >= 1", budget));
  return open_problems().add(
      std::make_unique<OpenedProblem>(instance(question.problem(shown), number), budget, seed));
}

}  // namespace
}  // namespace ricochet::interface

using namespace ricochet::interface;

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED ricochet_problem* ricochet_open(const char* question, const char* form,
                                         std::int32_t instance, std::int64_t budget,
                                         std::uint64_t seed) {
  ricochet_problem* opened = nullptr;
  succeeds([&] { opened = open(question, form, instance, budget, seed); });
  return opened;
}

EXPORTED void ricochet_close(ricochet_problem* problem) {
  if (problem) succeeds([&] { open_problems().close(problem); });
}

EXPORTED std::int32_t ricochet_judge(ricochet_problem* problem, const double* x, double* objective,
                                     double* violation) {
  const bool done = succeeds([&] {
    const ricochet::Truth truth = open_problems().at(problem).judge(x);
    if (objective) *objective = truth.objective;
    if (violation) *violation = truth.violation;
  });
  return done ? 0 : 1;
}

EXPORTED const char* ricochet_question_name(std::int32_t index) {
  const char* name = nullptr;
  succeeds([&] {
    const auto& all = questions();
    if (index < 0 || static_cast<std::size_t>(index) >= all.size()) return;
    name = all[static_cast<std::size_t>(index)].name().c_str();
  });
  return name;
}

EXPORTED const char* ricochet_error(void) {
  return last_error();
}
