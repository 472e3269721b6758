#include "src/benchmark/comparison/solver_facts.h"

#include <toml++/toml.h>

#include "embedded/solvers.h"
#include "src/core/patterns.h"

namespace ricochet::studies::comparison {
namespace {

const toml::table& facts() {
  static const toml::table all = toml::parse(embedded::solvers);
  return all;
}

std::string text(const toml::table& of, const char* key) {
  return of[key].value_or(std::string());
}

/// The first table of a list that names the solver; null if there is none.
const toml::table* first_with(const char* list, const std::string& solver) {
  for (const toml::node& node : *facts()[list].as_array()) {
    const toml::table& one = *node.as_table();
    for (const toml::node& pattern : *one["solvers"].as_array()) {
      if (fits(solver, pattern.value<std::string>().value())) return &one;
    }
  }
  return nullptr;
}

}  // namespace

std::optional<SolverSettings> settings_of(const std::string& solver) {
  const toml::table* one = first_with("settings", solver);
  if (one == nullptr) return std::nullopt;
  return SolverSettings{text(*one, "settings"), text(*one, "from"), text(*one, "note")};
}

std::string kind_of(const std::string& solver) {
  const toml::table* one = first_with("kind", solver);
  return one == nullptr ? "other" : text(*one, "name");
}

std::string library_note(const std::string& version) {
  for (const toml::node& node : *facts()["library"].as_array()) {
    const toml::table& one = *node.as_table();
    if (version.starts_with(text(one, "version"))) return text(one, "note");
  }
  return "";
}

}  // namespace ricochet::studies::comparison
