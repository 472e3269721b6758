#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "src/research/calibration/fit.h"

namespace ricochet::studies::calibration {

/// A requested fit: everything that determines the result of a search.
struct AskedFit {
  std::string kind;                                  ///< of search, solver and seed
  carrier_track::Parameterisation parameterisation;  ///< free parameters, and start of the search
  std::string left_out = {};                         ///< the case left out; empty: none
  std::string options;                               ///< evaluations, and versions of the solvers
  std::function<double(const Fit&)> loss;            ///< what it minimises

  /// Everything except the options, as a short text.
  std::string name() const;
};

/// The solvers of a search with their versions, and its evaluations.
std::string options_of(const Search& search);

/// Hash of the data of every fit: the cases with their claims, and the bounds and natural values of
/// the unknown parameters.
std::string data_hash(const std::vector<carrier_track::Case>& cases,
                      const std::vector<carrier_track::UnknownParameter>& parameters);

/// Finished fits, kept in a TOML file, so that an interrupted study can be resumed. Thread-safe.
class FitStore {
 public:
  /// Reads the file if it exists. Throws InputError if it is not a file of fits, is truncated, or
  /// was made by another version of the suite or with other data (data_hash).
  explicit FitStore(std::filesystem::path file);

  /// Returns nothing if there is no such fit. If there is one that differs only in the options,
  /// prints a line on standard error, once. Throws InputError if the loss of a fit from the file
  /// does not match its parameters.
  std::optional<Fit> find(const AskedFit& asked) const;

  /// Stores one fit for each request, and replaces the file atomically. Throws InputError if that
  /// fails.
  void add(const std::vector<AskedFit>& asked, const std::vector<Fit>& fits);

 private:
  struct Kept {
    Fit fit;         ///< only its parameters and its loss
    bool from_file;  ///< not verified yet
  };

  void check_loss(const AskedFit& asked, const Fit& fit) const;

  std::filesystem::path file_;
  mutable std::mutex mutex_;
  mutable bool told_ = false;                                ///< about fits with other options
  std::map<std::string, std::map<std::string, Kept>> fits_;  ///< by name and options
};

}  // namespace ricochet::studies::calibration
