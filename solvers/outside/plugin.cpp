#include "solvers/outside/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <ricochet/ricochet.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "ricochet/error.h"
#include "solvers/scaled_box.h"
#include "src/core/child_process.h"
#include "src/core/floating_point.h"
#include "src/core/names.h"
#include "src/core/seen_problem.h"

namespace ricochet::outside {

namespace {

using Json = nlohmann::json;

constexpr std::chrono::seconds longest_load{10};
constexpr double most_memory = 2000;  // [MB]

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError(path + ": " + reason);
}

const ricochet_solver& exported_by(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  reset_floating_point();  // its constructors may have changed it
  if (library == nullptr) {
    const std::string reason = dlerror();
    throw InputError(reason.starts_with(path) ? reason : path + ": " + reason);
  }
  const auto* exported = static_cast<const ricochet_solver*>(dlsym(library, "ricochet_plugin"));
  if (exported == nullptr) {
    refuse(path, "exports no ricochet_plugin; does it include <ricochet/ricochet.h>?");
  }
  if (exported->abi != RICOCHET_ABI) {
    refuse(path, fmt::format("is made for interface {}, this is {}; compile it again",
                             exported->abi, RICOCHET_ABI));
  }
  if (exported->solve == nullptr) refuse(path, "solve is NULL");
  return *exported;
}

/// The files of the shared libraries that this process has loaded, without those of the system.
std::set<std::string> loaded_libraries() {
  std::set<std::string> files;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* found) {
        const std::string name = info->dlpi_name;
        const bool own = name.find('/') != std::string::npos && !is_of_the_system(name);
        if (own) static_cast<std::set<std::string>*>(found)->insert(name);
        return 0;
      },
      &files);
  return files;
}

/// The claims of a library as JSON text, and the libraries that it brings along. To be called where
/// a library may do what it likes: its constructors run, and its pointers are followed.
std::string claims_text(const std::string& path) {
  const std::set<std::string> before = loaded_libraries();
  const ricochet_solver& exported = exported_by(path);
  std::vector<std::string> brought;
  for (const std::string& file : loaded_libraries()) {
    if (file != path && !before.contains(file)) brought.push_back(file);
  }
  const Json claims = {
      {"name", exported.name != nullptr ? std::string(exported.name)
                                        : std::filesystem::path(path).stem().string()},
      {"version", exported.version != nullptr ? exported.version : ""},
      {"takes_constraints", exported.takes_constraints},
      {"needs_derivatives", exported.needs_derivatives != 0},
      {"needs_residuals", exported.needs_residuals != 0},
      {"stochastic", exported.stochastic != 0},
      {"brought", brought}};
  return claims.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The claims of a library, which is loaded for this in another process. Adds the libraries that it
/// brings along to what the solver consists of.
Claims claims_of(const std::string& path, Content& content) {
  try {
    const Json claims = Json::parse(
        called_in_isolation([&] { return claims_text(path); }, longest_load, most_memory));
    for (const Json& file : claims.at("brought")) content.add_file(file.get<std::string>());
    return {claims.at("name").get<std::string>(),      claims.at("version").get<std::string>(),
            claims.at("takes_constraints").get<int>(), claims.at("needs_derivatives").get<bool>(),
            claims.at("needs_residuals").get<bool>(),  claims.at("stochastic").get<bool>()};
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    if (reason.starts_with(path)) throw InputError(reason);
    refuse(path, "cannot be loaded: the process that tried it " + reason);
  }
}

/// An exception thrown from here holds no reference to the library.
const char* solved(const ricochet_solver& exported, ricochet_problem* problem, Vector& point,
                   const std::string& path) {
  try {
    return exported.solve(problem, point.data());
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  } catch (...) {
    throw std::runtime_error(path + ": threw what is no std::exception");
  }
}

}  // namespace

Solver plugin(const std::string& path) {
  Content content;
  content.add_file(path);  // before it is loaded
  Solver solver = solver_as_claimed(claims_of(path, content), path);
  solver.content = content.hash();
  solver.changed_file = [content] { return content.changed(); };
  solver.solve = [path](Evaluator& evaluator, const Vector& start, Random& random) {
    return solve_by(exported_by(path), path, evaluator, start, random);
  };
  return solver;
}

SolverTermination solve_by(const ricochet_solver& exported, const std::string& path,
                           Evaluator& evaluator, const Vector& start, Random& random) {
  interface::SeenProblem problem(evaluator, start, random);
  problem.answer_this_thread_only();
  Vector point = start;
  const char* said = solved(exported, &problem, point, path);
  if (problem.failure()) std::rethrow_exception(problem.failure());
  if (problem.was_asked_by_others()) {
    throw std::runtime_error(path + ": asked its problem from a second thread");
  }
  SolverTermination exit{said != nullptr ? one_line(said) : "done"};
  if (evaluator.over()) exit.reason = stopped_by_evaluator;
  // A point left as it was is none, but for a solver that requested residuals only.
  if (point != start || evaluator.best_shown() == nullptr) exit.point = point;
  return exit;
}

Solver solver_as_claimed(const Claims& claims, const std::string& source) {
  const std::string& name = claims.name;
  if (!is_name(name)) {
    throw InputError(fmt::format("{}: name \"{}\"; allowed are {}", source, name, names_in_words));
  }
  if (claims.takes_constraints < 0 || claims.takes_constraints > 2) {
    throw InputError(fmt::format("{}: takes_constraints {}; allowed are 0, 1 and 2", source,
                                 claims.takes_constraints));
  }
  Solver solver;
  solver.name = name;
  solver.version = one_line(claims.version);
  solver.stochastic = claims.stochastic;
  using Constraints = Capabilities::Constraints;
  solver.capabilities.constraints =
      std::array{Constraints::none, Constraints::inequalities,
                 Constraints::all}[static_cast<std::size_t>(claims.takes_constraints)];
  if (claims.needs_derivatives) solver.capabilities.derivatives = Capabilities::Order::gradient;
  solver.capabilities.needs_residuals = claims.needs_residuals;
  return solver;
}

namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

bool is_program(const fs::path& path) {
  return is_file(path) && ::access(path.c_str(), X_OK) == 0;
}

/// Everything that changes if a file is written or replaced.
bool same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
         a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec &&
         a.st_ctim.tv_sec == b.st_ctim.tv_sec && a.st_ctim.tv_nsec == b.st_ctim.tv_nsec;
}

}  // namespace

Content::File Content::read(const fs::path& path) {
  File file{path, {}, 0};
  ::stat(path.c_str(), &file.status);
  FnvHash hash;
  std::ifstream in(path, std::ios::binary);
  std::string chunk(1 << 16, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
    hash.add(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  file.hash = hash.value();
  return file;
}

void Content::add_text(std::string_view text) {
  hash_.add(fmt::format("text of {} bytes: {}", text.size(), text));
}

void Content::add_file(const fs::path& file) {
  files_.push_back(read(file));
  hash_.add(fmt::format("file {:016x}", files_.back().hash));
}

std::string Content::hash() const {
  return fmt::format("{:016x}", hash_.value());
}

std::string Content::changed() const {
  for (const File& file : files_) {
    struct stat now {};
    const bool there = ::stat(file.path.c_str(), &now) == 0;
    if (there && same(now, file.status)) continue;
    if (!there || read(file.path).hash != file.hash) return file.path.string();
  }
  return "";
}

fs::path program_of(const std::vector<std::string>& words, const fs::path& folder) {
  const std::string& program = words.front();
  if (program.find('/') != std::string::npos) {
    return is_program(folder / program) ? folder / program : fs::path();
  }
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "/bin:/usr/bin");
  for (std::string each; std::getline(list, each, ':');) {
    const fs::path file = folder / each / program;
    if (is_program(file)) return file;
  }
  return {};
}

Content content_of_command(const std::vector<std::string>& words, const fs::path& folder) {
  Content content;
  const fs::path program = program_of(words, folder);
  if (!program.empty() && !is_of_the_system(program)) {
    content.add_file(program);
  } else {
    content.add_text(fs::path(words.front()).filename().string());
  }
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string& word = words[k];
    const std::size_t value = word.find('=') + 1;  // 0: there is no =
    if (is_file(folder / word)) {
      content.add_file(folder / word);
    } else if (value > 0 && is_file(folder / word.substr(value))) {
      content.add_text(word.substr(0, value));
      content.add_file(folder / word.substr(value));
    } else {
      content.add_text(word);
    }
  }
  return content;
}

bool is_of_the_system(const fs::path& file) {
  std::error_code none;
  const std::string place = fs::canonical(file, none).string();
  for (const char* folder : {"/usr/", "/bin/", "/sbin/", "/lib/", "/lib64/"}) {
    if (place.starts_with(folder)) return !place.starts_with("/usr/local/");
  }
  return false;
}

}  // namespace ricochet::outside
