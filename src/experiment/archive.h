#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "src/experiment/store.h"

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

// Compression to the .xz format (https://tukaani.org/xz/xz-file-format.txt), by liblzma.

/// Whether these bytes begin as an .xz file does.
bool is_xz(std::string_view bytes);

/// The bytes as an .xz file, as small as liblzma makes it: takes some 700 MB of memory, and a
/// second for each MB.
std::string xz_compressed(std::string_view bytes);

/// What such a file holds. Throws InputError if it is damaged, cut off, or holds more than `most`
/// bytes.
std::string xz_decompressed(std::string_view file, std::size_t most);

}  // namespace ricochet
