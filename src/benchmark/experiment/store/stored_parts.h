#pragma once

#include <string>
#include <vector>

#include "src/benchmark/experiment/store/repeated_terminations.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/core/fnv_hash.h"

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

}  // namespace ricochet
