#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/studies/calibration/fit.h"

namespace ricochet::studies::calibration {

/// Everything that decides what fit() or polish() returns, as a short text.
std::string key_of(const std::string& kind, const carrier_track::Freedom& freedom,
                   const Search& search, const std::string& left_out);

/// Finished fits, kept in a TOML file, so that a study that was stopped goes on where it was.
/// May be used from several threads at once.
class FitStore {
 public:
  /// Reads the file if there is one. Throws InputError where it is not one of fits.
  explicit FitStore(std::filesystem::path file);

  std::optional<Fit> find(const std::string& key) const;

  /// Keeps the fit and replaces the file, all or nothing. Throws InputError where it cannot.
  void add(const std::string& key, const Fit& fit);

  /// The same with several, each by its key: all of them or none.
  void add(const std::vector<std::pair<std::string, Fit>>& fits);

 private:
  std::filesystem::path file_;
  mutable std::mutex mutex_;
  std::map<std::string, Fit> fits_;
};

}  // namespace ricochet::studies::calibration
