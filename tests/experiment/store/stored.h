#pragma once

#include "tests/support/campaigns.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"

namespace ricochet {

inline Store reading(const fs::path& file) {
  return Store::open(file, Store::For::reading);
}

inline Store adding(const fs::path& file) {
  return Store::open(file, Store::For::adding);
}

inline std::vector<RunRecord> any_records(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<RunRecord> records;
  for (int k = 0; k < count; ++k) records.push_back(any::record(random));
  return records;
}

/// Adds these as runs of the keys from `first` on.
inline void add(Store& store, const std::vector<RunRecord>& records, int first = 0) {
  for (std::size_t k = 0; k < records.size(); ++k) {
    store.add(a_key(first + static_cast<int>(k)), records[k]);
  }
}

/// Of all runs of a store the bits, by key.
inline std::map<RunKey, std::vector<std::string>> bits_of(const Store& store) {
  std::map<RunKey, std::vector<std::string>> bits;
  store.each([&](const StoredRun& run) { bits[run.key] = bits_of(run.record); });
  return bits;
}

/// How many files there are in the folder.
inline auto number_of_files(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

/// Neither way to open the file does more than refuse, with its name and these words.
inline void expect_no_store(const fs::path& file, const std::string& words) {
  for (const auto purpose : {Store::For::reading, Store::For::adding}) {
    const auto opening = [&] {
      return Store::open(file, purpose).each([](const StoredRun&) {}), 0;
    };
    EXPECT_THAT(complaint_of(opening), AllOf(StartsWith(file.string()), HasSubstr(words)));
  }
}

}  // namespace ricochet
