#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "src/benchmark/experiment/store/store.h"

/// An archive is a compressed store of runs without their points, small enough to be kept with the
/// source. Commands that read a store read an archive, too.
namespace ricochet {

/// What an archive keeps of a run: all but its points and its seed, which a repetition gives; times
/// to two digits; of the improvements those to a twentieth of the optimality gap (seven digits, no
/// times), the first that solves, the first as good as the returned point, and the last.
RunRecord thinned(RunRecord record, const StoredProblem& problem);

/// In what a run that was made again differs from the stored one, of an archive too; empty if in
/// nothing.
std::string difference_when_repeated(const CampaignDescription& description,
                                     const StoredRun& stored, const RunRecord& again);

/// Whether runs of a campaign may be thinned: they are if its description is marked so.
bool is_archived(const CampaignDescription& description);
void mark_archived(CampaignDescription& description);

/// Writes these runs of a store as an archive, with further notes on how they were made. Throws
/// OutputError if it cannot be written.
void write_archive(const Store& store, const std::filesystem::path& out,
                   const std::function<bool(const RunKey&)>& wanted,
                   const std::map<std::string, std::string>& notes = {});

/// Whether a file begins as an archive does.
bool is_archive(const std::filesystem::path& file);

/// Unpacks an archive into a new file, a store of the thinned runs. Throws InputError if the
/// archive is damaged.
void unpack_archive(const std::filesystem::path& archive, const std::filesystem::path& out);

}  // namespace ricochet
