#include "src/cli/export.h"

#include <fmt/format.h>

#include "src/benchmark/experiment/store/store.h"
#include "src/benchmark/export/formats.h"
#include "src/benchmark/export/output_folder.h"
#include "src/cli/named.h"
#include "src/cli/stored_runs.h"
#include "src/core/one_line.h"

namespace ricochet::cli {

int export_store(const ExportOptions& options) {
  const exports::Format format = named(exports::all_formats(), options.format, "format",
                                       [](const exports::Format& known) { return known.name; });
  const Store store = Store::open(options.store, Store::For::reading);
  warn_of_missing_runs(options.store);
  exports::OutputFolder out(options.out);
  format.write(store, out.draft());
  out.commit();
  fmt::print("{} runs: {}\n", store.size(), one_line(options.out));
  return 0;
}

}  // namespace ricochet::cli
