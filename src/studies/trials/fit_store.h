#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "src/studies/trials/trial_search.h"

namespace ricochet::studies::trials {

/// Finished fits of trials, kept in a TOML file, so that a study that was stopped goes on where it
/// was. May be used from several threads at once.
class TrialFitStore {
 public:
  /// Reads the file if there is one. Throws InputError where it is not one of fits of trials.
  explicit TrialFitStore(std::filesystem::path file);

  std::optional<TrialFit> find(const std::string& key) const;

  /// Keeps the fit and replaces the file, all or nothing. Throws InputError where it cannot.
  void add(const std::string& key, const TrialFit& fit);

 private:
  std::filesystem::path file_;
  mutable std::mutex mutex_;
  std::map<std::string, TrialFit> fits_;
};

}  // namespace ricochet::studies::trials
