#include "solvers/outside/line_solver.h"

#include <fmt/format.h>
#include <wordexp.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "solvers/outside/claims.h"
#include "solvers/outside/content.h"
#include "solvers/outside/conversation.h"
#include "solvers/outside/line_program.h"

namespace ricochet::outside {
namespace {

std::vector<std::string> words_of(const std::string& command) {
  wordexp_t found{};
  const int code = wordexp(command.c_str(), &found, WRDE_NOCMD);
  std::vector<std::string> words;
  if (code == 0) words.assign(found.we_wordv, found.we_wordv + found.we_wordc);
  if (code == 0 || code == WRDE_NOSPACE) wordfree(&found);
  if (words.empty()) {
    throw InputError(command + ": is not one program with its arguments; put what a shell shall " +
                     "do into a script");
  }
  return words;
}

/// Started programs that wait for a start, each for the thread that started it.
class WaitingPrograms {
 public:
  explicit WaitingPrograms(std::vector<std::string> words) : words_(std::move(words)) {}

  std::unique_ptr<LineProgram> start(Claims& claims) const {
    auto program = std::make_unique<LineProgram>(words_);
    claims = greeting_of(*program);
    return program;
  }

  /// A program of this thread, or null if none waits.
  std::unique_ptr<LineProgram> take() {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](const auto& each) { return each->is_of_this_thread(); });
    if (found == waiting_.end()) return nullptr;
    auto program = std::move(*found);
    waiting_.erase(found);
    return program;
  }

  void give_back(std::unique_ptr<LineProgram> program) {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(program));
  }

 private:
  const std::vector<std::string> words_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<LineProgram>> waiting_;
};

/// One start. If the program ended after the last start, it is started again.
SolverTermination solve(WaitingPrograms& programs, Evaluator& evaluator, const Vector& start,
                        Random& random) {
  const auto seed = static_cast<std::uint32_t>(random() >> 32U);
  std::optional<SolverTermination> exit;
  std::unique_ptr<LineProgram> program = programs.take();
  if (program) exit = converse(*program, evaluator, start, seed);
  if (!exit) {
    Claims known;
    program = programs.start(known);
    exit = converse(*program, evaluator, start, seed);
  }
  if (!exit) throw std::runtime_error(program->how_it_ended() + " when it was given a problem");
  programs.give_back(std::move(program));
  return *exit;
}

}  // namespace

Solver line_solver(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  const Content content = content_of_command(words);  // before it is started
  const auto programs = std::make_shared<WaitingPrograms>(words);
  Claims claims;
  try {
    programs->give_back(programs->start(claims));
  } catch (const std::exception& error) {
    throw InputError(command + ": " + error.what());
  }
  Solver solver = solver_as_claimed(claims, command);
  solver.content = content.hash();
  solver.changed_file = [content] { return content.changed(); };
  solver.solve = [programs, command](Evaluator& evaluator, const Vector& start, Random& random) {
    try {
      return solve(*programs, evaluator, start, random);
    } catch (const std::exception& error) {
      throw std::runtime_error(command + ": " + error.what());
    }
  };
  return solver;
}

}  // namespace ricochet::outside
