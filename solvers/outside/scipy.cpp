#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "solvers/library_solvers.h"
#include "solvers/outside/line_solver.h"

namespace ricochet {

#ifdef RICOCHET_HAS_SCIPY

namespace {

namespace fs = std::filesystem;

/// Path of the program that serves the solvers, as installed beside this one, or else in the
/// sources; empty if it or SciPy is missing.
std::string served_by() {
  std::error_code error;
  if (!fs::exists(RICOCHET_SCIPY_FILE, error)) return {};
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed =
      program.parent_path().parent_path() / "share/ricochet/scipy_solvers.py";
  for (const fs::path& path : {installed, fs::path(RICOCHET_SCIPY_SOURCE)}) {
    if (fs::exists(path, error)) return path.string();
  }
  return {};
}

/// The running programs that have SciPy loaded, at most one for a thread.
class Servers {
 public:
  std::unique_ptr<outside::LineProgram> copy(const std::string& script) {
    const std::scoped_lock lock(mutex_);
    const auto serves = [](const auto& each) { return each->may_serve_this_thread(); };
    const auto found = std::find_if(servers_.begin(), servers_.end(), serves);
    if (found != servers_.end()) {
      if (auto program = (*found)->copy()) return program;
      servers_.erase(found);
    }
    // Isolated from the user's own modules and environment.
    servers_.push_back(std::make_unique<outside::ForkingProgram>(
        std::vector<std::string>{RICOCHET_PYTHON, "-I", script}));
    return servers_.back()->copy();
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<outside::ForkingProgram>> servers_;
};

Servers& servers() {
  static Servers all;
  return all;
}

std::unique_ptr<outside::LineProgram> started(const std::string& script) {
  std::unique_ptr<outside::LineProgram> program;
  std::string version;
  for (bool again = false; version.empty(); again = true) {
    try {
      program = servers().copy(script);
      if (!program) throw std::runtime_error("ended at once");
      version = outside::greeting_of(*program).version;
    } catch (const std::exception&) {  // of a server that was about to end?
      if (again) throw;
    }
  }
  if (version != RICOCHET_SCIPY_VERSION) {
    throw std::runtime_error(fmt::format("loaded SciPy {}, but ricochet was configured with {}",
                                         version, RICOCHET_SCIPY_VERSION));
  }
  return program;
}

}  // namespace

std::vector<Solver> scipy_solvers() {
  const std::string script = served_by();
  if (script.empty()) return {};
  const auto programs =
      std::make_shared<outside::WaitingPrograms>([script] { return started(script); });
  std::vector<Solver> solvers;
  for (const ScipySolver& each : scipy_list) {
    Solver solver;
    solver.name = each.name;
    solver.version = "SciPy " RICOCHET_SCIPY_VERSION;
    solver.stochastic = each.stochastic;
    solver.capabilities = each.capabilities;
    solver.prepare = [script] { servers().copy(script); };
    solver.solve = [programs, script, first = fmt::format("{{\"solver\": \"{}\"}}\n", each.name)](
                       Evaluator& evaluator, const Vector& start, Random& random) {
      try {
        return programs->solve(evaluator, start, random, first);
      } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("{} {}: {}", RICOCHET_PYTHON, script, error.what()));
      }
    };
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

#else

std::vector<Solver> scipy_solvers() {
  return {};
}

#endif

}  // namespace ricochet
