#include "src/export/formats.h"

#include "src/export/coco.h"
#include "src/export/csv.h"
#include "src/export/iohanalyzer.h"
#include "src/export/json_lines.h"
#include "src/export/latex.h"
#include "src/export/markdown.h"

namespace ricochet::exports {

std::vector<Format> all_formats() {
  return {{"csv", "runs.csv, improvements.csv, questions.csv: every figure", write_csv},
          {"json", "runs.jsonl, a line for each run, and campaign.json: every figure", write_json},
          {"latex", "table.tex, a longtable: what was solved, at what cost", write_latex},
          {"markdown", "table.md, the same", write_markdown},
          {"iohanalyzer", "for IOHanalyzer, a folder for each algorithm", write_iohanalyzer},
          {"coco", "for COCO's post-processing, a folder for each algorithm", write_coco}};
}

}  // namespace ricochet::exports
