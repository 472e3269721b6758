#include "src/app/interface/interface.h"

#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"
#include "src/app/interface/problem_functions.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/core/toml.h"
#include "src/studies/suite/suite.h"

/// How external programs open and close problems.
namespace ricochet::interface {

namespace {

constexpr double longest_threshold = 60;  // [s]

using Problems = std::shared_ptr<const std::vector<Problem>>;

/// Every problem, made at the first call in about a tenth of a second. Never destroyed, like
/// open_problems().
const std::vector<Problem>& problems() {
  static const auto& all = *new const std::vector<Problem>(every_problem(suite_families()));
  return all;
}

/// The problems of a machine file. Those of the last file are kept, since its threshold takes about
/// a second, until its text is another.
Problems problems_of(const std::string& scene) {
  struct Last {
    std::mutex mutex;
    std::string scene, text;
    Problems problems;
  };
  static auto& last = *new Last;
  const std::string text = scene_text(scene);
  const std::lock_guard lock(last.mutex);
  if (!last.problems || last.scene != scene || last.text != text) {
    const TimeLimit limit(longest_threshold);
    try {
      last.problems =
          std::make_shared<const std::vector<Problem>>(every_problem(carrier_track::families_of(
              {carrier_track::machine_of(carrier_track::parse_scene(text, scene), scene)})));
    } catch (const TimeLimitReached&) {
      throw std::runtime_error(
          fmt::format("{}: its problems need its threshold, which is not known after {} s", scene,
                      longest_threshold));
    }
    last.scene = scene;
    last.text = text;
  }
  return last.problems;
}

/// Throws InputError if there is no problem of this name.
const Problem& problem_named(const std::string& name, const std::vector<Problem>& among) {
  for (const Problem& problem : among) {
    if (problem.name == name) return problem;
  }
  std::vector<std::string> known;
  for (const Problem& problem : among) known.push_back(problem.name);
  throw InputError(fmt::format("{}: there is no such problem; {}", name,
                               what_instead(name, known, "`ricochet list problems`")));
}

ricochet_problem* open(const std::vector<Problem>& among, const char* name, const char* formulation,
                       std::int32_t number, std::int64_t budget, std::uint64_t seed) {
  if (!name) throw InputError("the name of the problem is NULL");
  const Problem& problem = problem_named(name, among);
  const Formulation shown = problem.formulation_named(formulation ? formulation : "");
  if (number < 0) throw InputError(fmt::format("instance {}: must be >= 0", number));
  if (budget < 1) throw InputError(fmt::format("budget {}: must be >= 1", budget));
  return open_problems().add(
      std::make_unique<OpenedProblem>(instance(problem.formulated(shown), number), budget, seed));
}

}  // namespace

OpenProblems& open_problems() {
  static auto& all = *new OpenProblems("problem");
  return all;
}

}  // namespace ricochet::interface

using namespace ricochet::interface;

RICOCHET_EXPORTED std::int32_t ricochet_abi(void) {
  return RICOCHET_ABI;
}

RICOCHET_EXPORTED const char* ricochet_version(void) {
  return RICOCHET_VERSION;
}

RICOCHET_EXPORTED ricochet_problem* ricochet_open(const char* problem, const char* formulation,
                                                  std::int32_t instance, std::int64_t budget,
                                                  std::uint64_t seed) {
  ricochet_problem* opened = nullptr;
  succeeds([&] { opened = open(problems(), problem, formulation, instance, budget, seed); });
  return opened;
}

RICOCHET_EXPORTED ricochet_problem* ricochet_open_scene(const char* scene, const char* problem,
                                                        const char* formulation,
                                                        std::int32_t instance, std::int64_t budget,
                                                        std::uint64_t seed) {
  ricochet_problem* opened = nullptr;
  succeeds([&] {
    opened = open(*problems_of(scene ? scene : ""), problem, formulation, instance, budget, seed);
  });
  return opened;
}

RICOCHET_EXPORTED void ricochet_close(ricochet_problem* problem) {
  if (problem) succeeds([&] { open_problems().close(problem); });
}

RICOCHET_EXPORTED const char* ricochet_problem_name(std::int32_t index) {
  const char* name = nullptr;
  succeeds([&] {
    const auto& all = problems();
    if (index < 0 || static_cast<std::size_t>(index) >= all.size()) return;
    name = all[static_cast<std::size_t>(index)].name.c_str();
  });
  return name;
}

RICOCHET_EXPORTED const char* ricochet_error(void) {
  return last_error();
}

namespace ricochet::interface {

namespace {

thread_local std::string kept;
thread_local const char* shown = "";

}  // namespace

const char* last_error() noexcept {
  return shown;
}

void keep_error(const std::exception_ptr& failure) noexcept {
  if (!failure) return;
  try {
    try {
      std::rethrow_exception(failure);
    } catch (const std::exception& error) {
      kept = one_line(error.what());
    } catch (...) {
      kept = "an exception that is not a std::exception";
    }
    shown = kept.c_str();
  } catch (...) {  // the message could not be stored
    shown = "there is not enough memory";
  }
}

std::string scene_text(const std::string& file) {
  if (file.empty()) throw InputError("the machine file has no name");
  return read_toml_text(file == "-" ? "/dev/stdin" : file);
}

}  // namespace ricochet::interface
