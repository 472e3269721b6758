#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/experiment/campaign.h"
#include "src/experiment/store.h"
#include "src/experiment/stored_campaign.h"

/// A user's solvers beside the solvers whose runs an archive has.
namespace ricochet {

/// The plan of an archive with the user's solvers added: as these are run, all runs of the others
/// are there. Leaves out solvers of the archive that the catalogue lacks. Only on problems that fit
/// the patterns, if there are any; throws InputError for a pattern that fits none of the archive's.
Plan plan_against(const CampaignDescription& archive, const std::vector<std::string>& own_solvers,
                  const Catalogue& catalogue, const std::vector<std::string>& problems = {});

/// Solvers of an archive that the catalogue lacks, or has in another version.
struct ChangedSolvers {
  std::vector<std::string> missing, changed;
};
ChangedSolvers changed_solvers(const CampaignDescription& archive, const Catalogue& catalogue);

/// Makes the store of such a plan's campaign in a new file, with the runs of the archive, but not
/// those of a user's solver that is another one now. Throws InputError if problems of the campaign
/// are not those of the archive, by their hashes.
void start_against(const Store& archive, const std::filesystem::path& archive_file,
                   const Campaign& campaign, const Provenance& provenance,
                   const std::filesystem::path& file);

/// Makes the store of a campaign in a new file, with those runs of other stores that are its own,
/// too: problem by hash, solver by version and content, then cell, instance and run; of equal ones
/// the first. Throws InputError if a store cannot be read.
void start_from(const std::vector<std::filesystem::path>& earlier, const Campaign& campaign,
                const Provenance& provenance, const std::filesystem::path& file);

/// Says which runs of a store were not made with it, and how far they were verified, in sentences;
/// empty if all were.
std::string foreign_runs_of(const CampaignDescription& description);

/// The description of two campaigns on the same problems whose solvers differ. Throws InputError if
/// the second has other problems, by their hashes, or another version or content of a solver.
CampaignDescription united(const CampaignDescription& first, const CampaignDescription& second);

/// Says in what a run contradicts its campaign: another budget than the plan's, a point of another
/// length, an objective that is proven to be out of reach. Empty if in nothing, or if the campaign
/// has no such run.
std::string contradiction(const Campaign& campaign, const StoredRun& run);

/// Says in what a store's problem differs from the campaign's of this name and hash; empty if in
/// nothing, or if there is none.
std::string contradiction(const CampaignDescription& ours, const StoredProblem& theirs);

/// The content of a store, compared with what this program knows. Throws InputError, naming `file`
/// and what contradicts it.
void check_content(const Campaign& campaign, const Store& store, const std::string& file);

}  // namespace ricochet
