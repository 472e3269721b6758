#include "solvers/outside/outside.h"

#include <unistd.h>

#include <filesystem>

#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/plugin.h"

namespace ricochet::outside {

std::optional<Solver> outside_solver(const std::string& text) {
  const bool has_space = text.find(' ') != std::string::npos;
  const bool is_path = text.find('/') != std::string::npos;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(text, ignored);
  if (!has_space && !is_path) {
    if (is_file && text.find('.') != std::string::npos) {
      throw InputError(text + ": a file is given with its folder, ./" + text);
    }
    return std::nullopt;
  }
  if (is_path && text.ends_with(".so") && (is_file || !has_space)) return plugin(text);
  if (has_space) return line_solver(text);
  if (!is_file) throw InputError(text + ": there is no such file");
  if (access(text.c_str(), X_OK) != 0) {
    throw InputError(text + ": is neither executable nor named .so; what runs it? " +
                     "For example \"python3 " + text + "\"");
  }
  return line_solver(text);
}

}  // namespace ricochet::outside
