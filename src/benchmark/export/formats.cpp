#include "src/benchmark/export/formats.h"

#include "src/benchmark/export/coco.h"
#include "src/benchmark/export/csv.h"
#include "src/benchmark/export/iohanalyzer.h"
#include "src/benchmark/export/json_lines.h"
#include "src/benchmark/export/latex.h"
#include "src/benchmark/export/markdown.h"

namespace ricochet::exports {

std::vector<Format> all_formats() {
  return {{"csv", "runs.csv, improvements.csv, problems.csv: every figure", write_csv},
          {"json", "runs.jsonl, a line for each run, and campaign.json: every figure", write_json},
          {"latex", "table.tex, a longtable: what was solved, at what cost", write_latex},
          {"markdown", "table.md, the same", write_markdown},
          {"iohanalyzer", "for IOHanalyzer, a folder for each algorithm", write_iohanalyzer},
          {"coco", "for COCO's post-processing, a folder for each algorithm", write_coco}};
}

}  // namespace ricochet::exports
