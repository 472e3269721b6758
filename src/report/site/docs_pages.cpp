#include "src/report/site/docs_pages.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "embedded/doc_architecture.h"
#include "embedded/doc_benchmark_method.h"
#include "embedded/doc_command_line.h"
#include "embedded/doc_identify.h"
#include "embedded/doc_impact_test.h"
#include "embedded/doc_machine_files.h"
#include "embedded/doc_other_languages.h"
#include "embedded/doc_own_solver.h"
#include "embedded/doc_paper.h"
#include "embedded/doc_plans_and_clusters.h"
#include "embedded/doc_reports.h"
#include "embedded/doc_security.h"
#include "embedded/doc_threshold_and_regimes.h"
#include "embedded/docs_template.h"
#include "embedded/document_template.h"
#include "embedded/look.h"
#include "embedded/search_script.h"
#include "src/core/text_file.h"
#include "src/report/data_text.h"
#include "src/report/file_set.h"
#include "src/report/filled_text.h"
#include "src/report/script_text.h"
#include "src/report/site/markdown.h"
#include "src/report/text.h"

namespace ricochet::site {
namespace {

namespace fs = std::filesystem;

/// Name and text of each file in docs/, in the order of the list.
constexpr std::pair<const char*, const char*> documents[] = {
    {"command-line", embedded::doc_command_line},
    {"machine-files", embedded::doc_machine_files},
    {"threshold-and-regimes", embedded::doc_threshold_and_regimes},
    {"identify", embedded::doc_identify},
    {"own-solver", embedded::doc_own_solver},
    {"other-languages", embedded::doc_other_languages},
    {"benchmark-method", embedded::doc_benchmark_method},
    {"plans-and-clusters", embedded::doc_plans_and_clusters},
    {"reports", embedded::doc_reports},
    {"impact-test", embedded::doc_impact_test},
    {"paper", embedded::doc_paper},
    {"architecture", embedded::doc_architecture},
    {"security", embedded::doc_security},
};

/// A text that the search looks through.
struct SearchEntry {
  std::string title, heading;
  std::string page;  ///< seen from the page of the search
  std::string text;
};
RICOCHET_WRITTEN_AS_JSON(SearchEntry, title, heading, page, text);

/// Leads links of a document in docs/NAME to pages of the site.
class Links {
 public:
  explicit Links(const fs::path& site) : site_(site) {}

  std::string operator()(const std::string& link) const {
    const std::size_t hash = std::min(link.find('#'), link.size());
    const std::string file = link.substr(0, hash), anchor = link.substr(hash);
    if (file.empty() || file.starts_with("https://")) return link;
    const fs::path path = (fs::path("docs") / file).lexically_normal();
    if (path.parent_path() == "docs" && path.extension() == ".md") {
      const std::string name = path.stem().string();
      const bool known = std::ranges::any_of(
          documents, [&](const auto& document) { return document.first == name; });
      return known ? "../" + name + "/index.html" + anchor : "";
    }
    return to_report(path);
  }

 private:
  /// NOTE: a page's anchors are not those of its summary; the link leads to its beginning.
  std::string to_report(const fs::path& path) const {
    const fs::path inside = path.lexically_relative("reports/reference");
    if (inside.empty() || *inside.begin() == "..") return "";
    const fs::path target =
        inside.extension() == ".md" ? inside.parent_path() / "index.html" : inside;
    std::error_code none;
    return fs::exists(site_ / target, none) ? "../../" + target.generic_string() : "";
  }

  fs::path site_;
};

std::string page_of(const char* sheet, Json data) {
  data["look"] = embedded::look;
  return report::filled(sheet, {&data});
}

}  // namespace

Place write_docs_pages(const fs::path& site, const std::vector<FoundReport>& reports) {
  const fs::path folder = below(site, docs_folder);
  Place place{"Data", "Docs and search", docs_folder};
  std::vector<SearchEntry> search;
  Json list = Json::array();
  for (const auto& [name, markdown] : documents) {
    const Document document = document_of(markdown, Links(site));
    const std::string title = report::escape_html(document.title);
    Json parts = Json::array();
    for (const DocumentPart& part : document.parts) {
      const std::string page = std::string(name) + "/index.html#" + part.anchor;
      search.push_back({document.title, part.heading, page, part.text});
      parts.push_back({{"heading", report::escape_html(part.heading)}, {"anchor", part.anchor}});
    }
    report::replace_files(
        below(folder, name),
        {{"index.html", page_of(embedded::document_template,
                                {{"title", title}, {"parts", parts}, {"html", document.html}})}});
    list.push_back({{"name", name}, {"title", title}});
    place.pages.emplace_back(name);
  }
  for (const FoundReport& report : reports) {
    if (!report.headline) continue;
    search.push_back({label_of(report), report.headline->title,
                      "../" + report.folder + "/index.html", report.headline->finding});
  }
  Json data = Json(search);
  report::replace_files(
      folder, {{"index.html",
                page_of(embedded::docs_template, {{"documents", list},
                                                  {"search", report::json_in_script(data.dump())},
                                                  {"script", embedded::search_script}})}});
  return place;
}

}  // namespace ricochet::site
