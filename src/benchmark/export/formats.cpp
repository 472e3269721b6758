#include "src/benchmark/export/formats.h"

#include "src/benchmark/export/coco.h"
#include "src/benchmark/export/csv.h"
#include "src/benchmark/export/iohanalyzer.h"
#include "src/benchmark/export/json_lines.h"
#include "src/benchmark/export/latex.h"
#include "src/benchmark/export/latex_summary.h"
#include "src/benchmark/export/markdown.h"
#include "src/benchmark/export/ratings.h"

namespace ricochet::exports {

std::vector<Format> all_formats() {
  return {{"csv", "runs.csv, points.csv, running_times.csv, ratings.csv, ecdf.csv and others",
           write_csv, write_ratings},
          {"json", "runs.jsonl, a line for each run, and campaign.json: every figure", write_json},
          {"latex", "summary.tex, the first entries on a page; table.tex, a longtable of all",
           write_latex, write_latex_summary},
          {"markdown", "table.md, what was solved, at what cost", write_markdown},
          {"iohanalyzer", "for IOHanalyzer, a folder for each algorithm", write_iohanalyzer},
          {"coco", "for COCO's post-processing, a folder for each algorithm", write_coco}};
}

}  // namespace ricochet::exports
