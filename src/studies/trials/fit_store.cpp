#include "src/studies/trials/fit_store.h"

#include <toml++/toml.h>

#include <sstream>

#include "src/core/error.h"
#include "src/core/text_file.h"
#include "src/core/toml_text.h"

namespace ricochet::studies::trials {
namespace {

template <class Numbers>
toml::array array_of_numbers(const Numbers& numbers) {
  toml::array array;
  for (const double number : numbers) array.push_back(number);
  return array;
}

std::optional<std::vector<double>> numbers_of(const toml::array* array) {
  if (array == nullptr) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& node : *array) {
    const auto number = node.value<double>();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<TrialFit> trial_fit_of(const toml::table& table) {
  const auto misfit = table["misfit"].value<double>();
  const auto base = numbers_of(table["base"].as_array());
  const auto own = numbers_of(table["own"].as_array());
  if (!misfit || !own || !base || base->size() != carrier_track::open_size) return std::nullopt;
  TrialFit fit{{{}, *own}, *misfit};
  std::copy(base->begin(), base->end(), fit.constants.base.begin());
  return fit;
}

}  // namespace

TrialFitStore::TrialFitStore(std::filesystem::path file) : file_(std::move(file)) {
  if (!std::filesystem::exists(file_)) return;
  const InputError error(file_.string() +
                         ": is no file of fits: must be one that ricochet trials wrote");
  toml::table root;
  try {
    root = parse_toml_file(file_);
  } catch (const InputError&) {
    throw error;
  }
  const toml::array* fits = root["trial"].as_array();
  if (fits == nullptr) throw error;
  for (const toml::node& node : *fits) {
    const toml::table* table = node.as_table();
    const auto key = table == nullptr ? std::nullopt : (*table)["key"].value<std::string>();
    const auto fit = key ? trial_fit_of(*table) : std::nullopt;
    if (!fit) throw error;
    fits_.insert_or_assign(*key, *fit);
  }
}

std::optional<TrialFit> TrialFitStore::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto found = fits_.find(key);
  return found == fits_.end() ? std::nullopt : std::optional(found->second);
}

void TrialFitStore::add(const std::string& key, const TrialFit& fit) {
  const std::lock_guard lock(mutex_);
  fits_.insert_or_assign(key, fit);
  toml::array tables;
  for (const auto& [each_key, each] : fits_) {
    tables.push_back(toml::table{{"key", each_key},
                                 {"misfit", each.misfit},
                                 {"base", array_of_numbers(each.constants.base)},
                                 {"own", array_of_numbers(each.constants.own)}});
  }
  std::ostringstream text;
  text << toml::table{{"trial", tables}} << '\n';
  write_text_file(file_, text.str());
}

}  // namespace ricochet::studies::trials
