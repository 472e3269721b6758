#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "src/experiment/campaign.h"
#include "src/experiment/store.h"

namespace ricochet {

/// Who and what made a store; see CampaignDescription.
struct Provenance {
  std::map<std::string, std::string> program, made;
};

/// A campaign and the store of its runs.
struct StoredCampaign {
  /// The key in CampaignDescription::made of the plan's text for a user's solver of this name.
  static std::string program_key(const std::string& solver) { return "program of " + solver; }

  /// The same of what this solver takes, by text_of().
  static std::string capabilities_key(const std::string& solver) {
    return "capabilities of " + solver;
  }

  Campaign campaign;
  Store store;
};

/// What a user's solver takes, as text for a store, and read from it again.
std::string text_of(const Capabilities& capabilities);
Capabilities capabilities_from(const std::string& text);

/// The description of the store of a campaign that is made here.
CampaignDescription description_of(const Campaign& campaign, const Provenance& provenance);

/// Runs of other stores that are taken over into a campaign's store: of equal problems, by hash,
/// and equal solvers, by version and content; of runs with the same key the first.
class TakenOver {
 public:
  enum class Versions { equal, any_of_the_suite };

  /// `ours` describes the campaign's store. Both must outlive it.
  TakenOver(const Campaign& campaign, const CampaignDescription& ours,
            Versions versions = Versions::equal)
      : campaign_(campaign), ours_(ours), versions_(versions) {}

  /// Passes to `add` what is taken over from a store.
  void take(const Store& store, const Store::AddRun& add);

  /// Says of which solvers runs were left out because they are other ones now.
  void tell_outdated() const;

 private:
  const Campaign& campaign_;
  const CampaignDescription& ours_;
  Versions versions_;
  std::set<RunKey> taken_, outdated_;
};

/// The campaign of a plan, after a parallel search for unknown values of its problems. Before the
/// search it calls `planned`, if that is not empty.
Campaign searched_campaign(const Plan& plan, const Catalogue& catalogue,
                           const std::function<void(const Campaign&)>& planned = nullptr);

/// The campaign of a plan, with the search results from when the store was made.
Campaign campaign_of(const CampaignDescription& description, const Plan& plan,
                     const Catalogue& catalogue);

/// Makes the store of a plan's campaign, or continues the existing one. If a user's solver is
/// another one now, its runs are removed from the store, which says so. Any program may open a
/// store that lacks no run, to read it. Before the search for unknown values of a new one it calls
/// `planned`, if that is not empty. Throws InputError if the store is of another plan, program or
/// data; then it stays unchanged.
StoredCampaign stored_campaign(const Plan& plan, const Catalogue& catalogue,
                               const std::filesystem::path& file, const Provenance& provenance,
                               const std::function<void(const Campaign&)>& planned = nullptr);

}  // namespace ricochet
