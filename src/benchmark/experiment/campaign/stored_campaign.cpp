#include "src/benchmark/experiment/campaign/stored_campaign.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/progress.h"

namespace ricochet {
namespace {

AllFindings found_by_search(const std::map<std::string, SearchedProblem>& problems) {
  std::vector<std::pair<const SearchedProblem*, Findings*>> searches;
  AllFindings all;
  for (const auto& [name, problem] : problems) searches.emplace_back(&problem, &all[name]);
  Progress progress("searching best values", static_cast<double>(searches.size()));
  tbb::parallel_for(std::size_t{0}, searches.size(), [&](std::size_t k) {
    *searches[k].second = searches[k].first->search();
    progress.advance(1);
  });
  return all;
}

StoredCampaign resumed(const Plan& plan, const Catalogue& catalogue,
                       const std::filesystem::path& file, const Provenance& provenance) {
  const auto refuse = [&](const char* what) {
    throw InputError(fmt::format("{}: is {}: choose another --out", file.string(), what));
  };
  Store found = Store::open(file, Store::For::reading);
  CampaignDescription theirs = found.description();
  if (theirs.plan != text_of(plan)) refuse("of another plan");
  Campaign campaign = campaign_of(theirs, plan, catalogue);
  const CampaignDescription ours = description_of(campaign, provenance);
  theirs.made = ours.made;
  const bool same_program = std::exchange(theirs.program, ours.program) == ours.program;
  const bool whole = found.size() == campaign.runs();
  if (theirs != ours || (!whole && !same_program)) {
    refuse(same_program ? "of other problems or solvers" : "made by another program");
  }
  if (!whole) found = Store::open(file, Store::For::adding);
  return {std::move(campaign), std::move(found)};
}

}  // namespace

CampaignDescription description_of(const Campaign& campaign, const Provenance& provenance) {
  CampaignDescription description = campaign.description();
  description.program = provenance.program;
  description.made = provenance.made;
  for (const auto& [name, text] : campaign.own_texts()) {
    description.made[StoredCampaign::program_key(name)] = text;
  }
  return description;
}

Campaign searched_campaign(const Plan& plan, const Catalogue& catalogue,
                           const std::function<void(const Campaign&)>& planned) {
  Campaign campaign(plan, catalogue);
  if (planned) planned(campaign);
  if (campaign.to_search().empty()) return campaign;
  return {plan, catalogue, found_by_search(campaign.to_search())};
}

Campaign campaign_of(const CampaignDescription& description, const Plan& plan,
                     const Catalogue& catalogue) {
  Campaign planned(plan, catalogue);
  if (planned.to_search().empty()) return planned;
  AllFindings found;
  for (const auto& [name, problem] : planned.to_search()) found[name];  // no feasible point
  for (const StoredProblem& problem : description.problems) {
    const auto place = found.find(problem.name);
    if (place != found.end()) place->second = problem.findings;
  }
  return {plan, catalogue, found};
}

StoredCampaign stored_campaign(const Plan& plan, const Catalogue& catalogue,
                               const std::filesystem::path& file, const Provenance& provenance,
                               const std::function<void(const Campaign&)>& planned) {
  if (std::filesystem::exists(file)) return resumed(plan, catalogue, file, provenance);
  Campaign campaign = searched_campaign(plan, catalogue, planned);
  Store store = Store::create(file, description_of(campaign, provenance));
  return {std::move(campaign), std::move(store)};
}

}  // namespace ricochet
