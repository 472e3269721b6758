#include "src/studies/calibration/fit_store.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

#include "src/core/error.h"
#include "src/core/seed.h"
#include "src/core/text_file.h"
#include "src/core/toml_text.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

toml::table table_of(const std::string& key, const Fit& fit) {
  toml::array freed;
  for (const Open open : fit.freed) {
    freed.push_back(open_constants()[static_cast<std::size_t>(open)].name);
  }
  toml::array constants;
  for (const double value : fit.constants) constants.push_back(value);
  return toml::table{{"key", key},
                     {"reading", name_of(fit.reading)},
                     {"left_out", fit.left_out},
                     {"misfit", fit.misfit},
                     {"freed", freed},
                     {"constants", constants}};
}

std::optional<Open> open_named(std::string_view name) {
  for (std::size_t i = 0; i < open_size; ++i) {
    if (open_constants()[i].name == name) return static_cast<Open>(i);
  }
  return std::nullopt;
}

std::optional<Fit> fit_of(const toml::table& table) {
  const auto reading = table["reading"].value<std::string>();
  const auto left_out = table["left_out"].value<std::string>();
  const auto misfit = table["misfit"].value<double>();
  const toml::array* freed = table["freed"].as_array();
  const toml::array* constants = table["constants"].as_array();
  if (!reading || !left_out || !misfit || freed == nullptr || constants == nullptr ||
      constants->size() != open_size) {
    return std::nullopt;
  }
  Fit fit{find_reading(*reading), {}, {}, *misfit, *left_out};
  for (const toml::node& name : *freed) {
    const auto open = open_named(name.value_or(std::string_view()));
    if (!open) return std::nullopt;
    fit.freed.push_back(*open);
  }
  for (std::size_t i = 0; i < open_size; ++i) {
    const auto value = constants->get(i)->value<double>();
    if (!value) return std::nullopt;
    fit.constants[i] = *value;
  }
  return fit;
}

}  // namespace

std::string key_of(const std::string& kind, const Freedom& freedom, const Search& search,
                   const std::string& left_out) {
  std::string text = fmt::format("{} {} {} {} {} {} {} {}", kind, name_of(freedom.reading),
                                 search.global.name, search.least_squares.name, search.local.name,
                                 search.evaluations, search.seed, left_out);
  for (const Open open : freedom.freed) text += fmt::format(" {}", static_cast<int>(open));
  for (const double value : freedom.held) text += fmt::format(" {}", value);
  return fmt::format("{} {} {} {} {:016x}", kind, name_of(freedom.reading), search.global.name,
                     search.seed, seed_of(text, "", 0, 0));
}

FitStore::FitStore(std::filesystem::path file) : file_(std::move(file)) {
  if (!std::filesystem::exists(file_)) return;
  const InputError error(file_.string() +
                         ": is no file of fits: must be one that ricochet calibrate wrote");
  toml::table root;
  try {
    root = parse_toml_file(file_);
  } catch (const InputError&) {
    throw error;
  }
  const toml::array* fits = root["fit"].as_array();
  if (fits == nullptr) throw error;
  for (const toml::node& node : *fits) {
    const toml::table* table = node.as_table();
    const auto key = table == nullptr ? std::nullopt : (*table)["key"].value<std::string>();
    const auto fit = key ? fit_of(*table) : std::nullopt;
    if (!fit) throw error;
    fits_.insert_or_assign(*key, *fit);
  }
}

std::optional<Fit> FitStore::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = fits_.find(key);
  return found == fits_.end() ? std::nullopt : std::optional(found->second);
}

void FitStore::add(const std::string& key, const Fit& fit) {
  add(std::vector{std::pair{key, fit}});
}

void FitStore::add(const std::vector<std::pair<std::string, Fit>>& fits) {
  const std::lock_guard lock(mutex_);
  for (const auto& [key, fit] : fits) fits_.insert_or_assign(key, fit);
  toml::array tables;
  for (const auto& [each_key, each] : fits_) tables.push_back(table_of(each_key, each));
  std::ostringstream text;
  text << toml::table{{"fit", tables}} << '\n';
  write_text_file(file_, text.str());
}

}  // namespace ricochet::studies::calibration
