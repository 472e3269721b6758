#include "problems/own/program.h"

#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <exception>
#include <filesystem>
#include <utility>

#include "problems/own/ways.h"
#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/plugin.h"
#include "src/core/names.h"

namespace ricochet::own {

namespace {

using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

/// Calls `visit` with each part of what was given, as numbers in a row.
template <class AnyGiven, class Visit>
void visit_parts(AnyGiven& given, const Visit& visit) {
  visit(&given.objective, 1);
  const auto part = [&](auto& each) { visit(each.data(), each.size()); };
  part(given.constraints);
  part(given.gradient);
  part(given.jacobian);
  part(given.residuals);
  part(given.residual_jacobian);
}

}  // namespace

Given nothing_given(const ProblemFile& file, bool derivatives) {
  const auto n = static_cast<Eigen::Index>(file.variables.size());
  const auto m = static_cast<Eigen::Index>(file.constraints.size());
  const Eigen::Index r = file.program.residuals;
  Given given;
  given.objective = missing;
  given.constraints = Vector::Constant(m, missing);
  given.residuals = Vector::Constant(r, missing);
  if (derivatives) {
    given.gradient = Vector::Constant(n, missing);
    given.jacobian = Rows::Constant(m, n, missing);
    given.residual_jacobian = Rows::Constant(r, n, missing);
  }
  return given;
}

std::string bytes_of(const Given& given) {
  std::string bytes;
  visit_parts(given, [&bytes](const double* numbers, Eigen::Index size) {
    bytes.append(reinterpret_cast<const char*>(numbers),
                 static_cast<std::size_t>(size) * sizeof(double));
  });
  return bytes;
}

bool read_bytes(std::string_view bytes, Given& given) {
  Eigen::Index size = 0;
  visit_parts(given, [&size](const double* /*numbers*/, Eigen::Index of_part) { size += of_part; });
  if (bytes.size() != static_cast<std::size_t>(size) * sizeof(double)) return false;
  visit_parts(given, [&bytes](double* numbers, Eigen::Index of_part) {
    const std::size_t length = static_cast<std::size_t>(of_part) * sizeof(double);
    if (length > 0) std::memcpy(numbers, bytes.data(), length);
    bytes.remove_prefix(length);
  });
  return true;
}

Program::~Program() = default;

Program::Program(ProblemFile file) : file_(std::move(file)) {
  const FileProgram& p = file_.program;
  outside::Content content;
  const fs::path folder = folder_of(file_);
  if (!p.library.empty()) {
    const fs::path library = folder / p.library;
    if (!fs::is_regular_file(library)) {
      throw InputError(
          fmt::format("{}: library = '{}': there is no such file", file_.path.string(), p.library));
    }
    content.add_file(library);
  } else if (!p.told) {
    const std::string& call = p.command.empty() ? p.executable : p.command;
    const std::vector<std::string> words = outside::words_of(call);
    content = outside::content_of_command(words, folder);
    if (outside::program_of(words, folder).empty()) {
      throw InputError(fmt::format("{}: {} = '{}': there is no such program", file_.path.string(),
                                   p.command.empty() ? "executable" : "command", one_line(call)));
    }
  }
  for (const std::string& each : p.files) {
    if (!fs::is_regular_file(folder / each)) {
      throw InputError(
          fmt::format("{}: files: '{}': there is no such file", file_.path.string(), each));
    }
    content.add_file(folder / each);
  }
  // Values of another list of constraints, or with other parts, are others.
  for (const FileVariable& v : file_.variables) content.add_text(v.name);
  for (const FileConstraint& c : file_.constraints) {
    content.add_text(fmt::format("{} {}", c.name, static_cast<int>(c.kind)));
  }
  for (const std::string& output : p.outputs) content.add_text(output);
  content.add_text(fmt::format("{} residuals", p.residuals));
  content_ = content.hash();
}

std::string Program::command() const {
  const FileProgram& p = file_.program;
  if (p.told) return "tell";
  return one_line(p.library.empty() ? p.command + p.executable : p.library);
}

Given Program::evaluate(const Vector& x, bool derivatives) {
  const auto begin = Clock::now();
  Given given;
  try {
    std::unique_ptr<Way> way = waiting_.take();
    if (!way) way = way_of(file_);
    given = way->evaluate(x, derivatives);
    waiting_.give_back(std::move(way));
  } catch (const std::exception& error) {
    given = nothing_given(file_, derivatives);
    given.failure = one_line(error.what());
  }
  given.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return given;
}

}  // namespace ricochet::own
