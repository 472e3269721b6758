#pragma once

#include <string>
#include <vector>

#include "src/core/fnv_hash.h"
#include "src/store/repeated_exits.h"
#include "src/store/store.h"

namespace ricochet {

/// A part of what a store keeps, as bytes that differ where any bit of it does.
struct StoredPart {
  std::string name;  ///< for messages
  std::string bytes;
};

/// What makes a campaign that campaign: all but `made`.
std::vector<StoredPart> parts_of(const CampaignDescription& description);

/// What a repetition of the run must bring again: all of it that a store keeps, but times.
std::vector<StoredPart> parts_of(const RunRecord& record);

/// The name of the first part that differs, or that one alone has; empty where there is none.
std::string difference(const std::vector<StoredPart>& ours, const std::vector<StoredPart>& theirs);

/// Of all that is stored, times and places too, to see damage. The run's exits are given apart.
std::uint64_t checksum(const CampaignDescription& description);
std::uint64_t checksum(const RunKey& key, const RunRecord& record,
                       const std::vector<RepeatedExit>& exits);

/// See Store::digest. To be told of the runs in the order of their keys.
class Digest {
 public:
  explicit Digest(const CampaignDescription& description);
  void add(const RunKey& key, const RunRecord& record);
  std::string text() const;  ///< 16 hexadecimal digits

 private:
  FnvHash hash_;
};

}  // namespace ricochet
