#pragma once

#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/core/instance.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/store.h"

namespace ricochet {

/// A part of the stored data, as bytes that differ if any bit of it does.
struct StoredPart {
  std::string name;  ///< for messages
  std::string bytes;
};

/// The parts that identify a campaign: all but `made`.
std::vector<StoredPart> parts_of(const CampaignDescription& description);

/// The parts that a repetition of the run must reproduce: all that a store keeps, except times.
std::vector<StoredPart> parts_of(const RunRecord& record);

/// The name of the first part that differs or that only one has; empty if there is none.
std::string difference(const std::vector<StoredPart>& ours, const std::vector<StoredPart>& theirs);

/// Checksum of all stored data, including times and places, to detect damage. The run's
/// terminations are given separately.
std::uint64_t checksum(const CampaignDescription& description);
std::uint64_t checksum(const RunKey& key, const RunRecord& record,
                       const std::vector<RepeatedTermination>& terminations);

/// See Store::digest. Runs must be added in the order of their keys.
class Digest {
 public:
  explicit Digest(const CampaignDescription& description);
  void add(const RunKey& key, const RunRecord& record);
  std::string text() const;  ///< 16 hexadecimal digits

 private:
  FnvHash hash_;
};

/// Says of a record what no run can have: "charged is 61: must be from 0 to 60, the evaluations
/// allowed". Empty if there is nothing. It knows neither problem nor plan. Holds for thinned
/// records too, in whose traces times are left out and objectives are rounded to floats.
std::string impossibility(const RunRecord& record);

/// The most starts of a solver in one run.
constexpr std::int64_t most_starts = 10'000'000;

}  // namespace ricochet
