#include "src/site/front_page.h"

#include "embedded/chart_library.h"
#include "embedded/front_script.h"
#include "embedded/front_summary_template.h"
#include "embedded/front_template.h"
#include "embedded/look.h"
#include "src/report/filled_text.h"
#include "src/report/gnuplot.h"
#include "src/report/text.h"
#include "src/site/front_charts.h"
#include "src/site/pairs.h"

namespace ricochet::site {
namespace {

using report::Json;

/// The data with every text fit for the page.
Json written(const Json& data, std::string (*write)(std::string_view)) {
  if (data.is_string()) return write(data.get_ref<const std::string&>());
  if (!data.is_structured()) return data;
  Json copy = data;
  for (auto& part : copy) part = written(part, write);
  return copy;
}

/// JSON that no script's end can stand in.
std::string inside_a_script(const Json& data) {
  std::string text;
  for (const char c : data.dump()) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

/// What the texts of the page speak of: all but what is for the script alone.
Json told(const Json& data) {
  Json part = data;
  for (const char* drawn : {"contest", "motion", "pairs"}) part.erase(drawn);
  const Json& pairs = data.at("pairs");
  part["pairs_finding"] = pairs.is_null() ? Json() : Json(pairs_finding(pairs));
  return part;
}

}  // namespace

report::FileSet front_page(const Json& data, const std::string& navigation) {
  const std::vector<report::Chart> charts = front_charts(data);
  const Json shown = {
      {"contest", data.at("contest")}, {"motion", data.at("motion")}, {"pairs", data.at("pairs")}};
  Json page = written(told(data), report::escape_html);
  page["navigation"] = navigation;
  std::vector<std::string> drawn = report::to_svgs(charts);
  page["pairs_chart"] = nullptr;
  if (!data.at("pairs").is_null()) {  // the last
    page["pairs_chart"] = std::move(drawn.back());
    drawn.pop_back();
  }
  page["charts"] = std::move(drawn);
  page["look"] = embedded::look;
  page["data"] = inside_a_script(shown);
  page["has_contest"] = !data["contest"].is_null();
  page["has_motion"] = !data["motion"].is_null();
  page["has_pairs"] = !data["pairs"].is_null();
  page["has_missing"] = !data.at("missing").empty();
  page["has_questions"] = !data.at("questions").empty();
  page["has_charts"] = !charts.empty();
  page["has_places"] = !page["solvers"].is_null() && !page["solvers"]["places"].empty();
  page["has_map"] = !page["solvers"].is_null() && !page["solvers"]["map"]["rows"].empty();
  page["chart_library"] = embedded::chart_library;
  page["script"] = embedded::front_script;
  Json summary = written(told(data), report::escape_markdown);
  summary["has_questions"] = page["has_questions"];
  return {{"index.html", report::filled(embedded::front_template, {&page})},
          {"summary.md", report::filled(embedded::front_summary_template, {&summary})}};
}

}  // namespace ricochet::site
