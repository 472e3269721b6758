#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include "ricochet/error.h"
#include "src/benchmark/experiment/store/draft_store.h"
#include "src/benchmark/experiment/store/run_rows.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/benchmark/experiment/store/stored_parts.h"
#include "src/core/text_file.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

/// The description of all parts.
CampaignDescription joined(const fs::path& first, const CampaignDescription& ours,
                           const fs::path& part, const CampaignDescription& theirs,
                           const United& united) {
  const std::string differs = difference(parts_of(ours), parts_of(theirs));
  if (differs.empty()) return ours;
  try {
    if (united) return united(ours, theirs);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: cannot be joined with {}: {}", part.string(), first.string(),
                                 error.what()));
  }
  throw InputError(fmt::format("{}: is of another campaign than {}, from which it differs in {}",
                               part.string(), first.string(), differs));
}

void add(RunRows& rows, const StoredRun& run, const fs::path& part) {
  const auto there = rows.find(run.key);
  if (!there) return rows.add(run.key, run.record);
  const std::string differs = difference(parts_of(there->record), parts_of(run.record));
  if (differs.empty()) return;
  throw InputError(fmt::format("{}: {} differs in {} from what a file before it has", part.string(),
                               name_of(run.key), differs));
}

}  // namespace

void merge(const std::vector<fs::path>& parts, const fs::path& out, const United& united,
           const std::map<std::string, std::string>& made) {
  if (parts.empty()) throw InputError(fmt::format("{}: there is nothing to merge", out.string()));
  // One at a time: there may be more parts than files may be open.
  CampaignDescription description = Store::open(parts[0], Store::For::reading).description();
  for (const fs::path& part : parts) {
    const Store store = Store::open(part, Store::For::reading);
    description = joined(parts[0], description, part, store.description(), united);
  }
  for (const auto& [name, value] : made) description.made[name] = value;
  DraftStore draft(out, description);
  try {
    SQLite::Transaction all(draft.database());
    RunRows rows(draft.database());
    for (const fs::path& part : parts) {
      Store::open(part, Store::For::reading).each([&](const StoredRun& run) {
        try {
          add(rows, run, part);
        } catch (const SQLite::Exception& error) {  // an error of the draft, not of the part
          throw OutputError(fmt::format("{}: cannot be written: {}", out.string(), error.what()));
        }
      });
    }
    all.commit();
  } catch (const SQLite::Exception& error) {
    throw OutputError(fmt::format("{}: cannot be written: {}", out.string(), error.what()));
  }
  draft.place();
}

}  // namespace ricochet
