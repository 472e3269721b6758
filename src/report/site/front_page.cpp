#include "src/report/site/front_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "embedded/chart_axes_script.h"
#include "embedded/chart_data_script.h"
#include "embedded/front_accuracy_script.h"
#include "embedded/front_board_script.h"
#include "embedded/front_chart_script.h"
#include "embedded/front_chooser_script.h"
#include "embedded/front_comparison_script.h"
#include "embedded/front_curves_script.h"
#include "embedded/front_data_script.h"
#include "embedded/front_motion_script.h"
#include "embedded/front_pairs_script.h"
#include "embedded/front_summary_template.h"
#include "embedded/front_template.h"
#include "embedded/look.h"
#include "src/report/column_labels.h"
#include "src/report/data_text.h"
#include "src/report/drawn_chart.h"
#include "src/report/filled_text.h"
#include "src/report/script_text.h"
#include "src/report/site/front_charts.h"
#include "src/report/text.h"

namespace ricochet::site {
namespace {

/// Returns the data with every text escaped for the page.
Json written(const Json& data, std::string (*write)(std::string_view)) {
  if (data.is_string()) return write(data.get_ref<const std::string&>());
  if (!data.is_structured()) return data;
  Json copy = data;
  for (auto& part : copy) part = written(part, write);
  return copy;
}

/// A heading over tables and commands.
struct Topic {
  const char *id, *question;
  const char* none;  ///< shown if there are no excerpts
  const char* invitation;
  std::vector<const char*> commands;
  std::vector<FrontExcerpt> Front::*excerpts;
};

const Topic topics[] = {
    {"speed",
     "Fastest quiet speeds",
     "Not computed yet: ./ricochet reproduce",
     "A machine of your own:",
     {"./ricochet machine new > machine.toml", "./ricochet machine advise machine.toml"},
     &Front::speed},
    {"solver",
     "First solver by kind of problem",
     "No solvers compared yet: ./ricochet compare",
     "",
     {},
     &Front::solver},
    {"own",
     "Your own solver",
     "Write it in any language. It gets the same formulation as every solver; ricochet counts its "
     "evaluations, stops it and scores it. One run; then its place among the others, on this page:",
     "",
     {"./ricochet solve \"python3 mine.py\" top-speed-C3",
      "./ricochet compare --solver \"python3 mine.py\""},
     &Front::own},
};

Json excerpt_data(const FrontExcerpt& excerpt) {
  Json data = excerpt;
  data["has_table"] = !excerpt.rows.empty();
  std::vector<std::string> titles;
  for (const FrontColumn& column : excerpt.columns) titles.push_back(column.title);
  data["labels"] = report::column_labels(titles);
  data["has_links"] = !excerpt.links.empty();
  return data;
}

Json answers(const Front& front) {
  return report::list_of(topics, [&](const Topic& topic) -> Json {
    Json excerpts = report::list_of(front.*topic.excerpts, excerpt_data);
    return {{"id", topic.id},
            {"question", topic.question},
            {"none", topic.none},
            {"invitation", topic.invitation},
            {"has_commands", !topic.commands.empty()},
            {"commands", topic.commands},
            {"has_excerpts", !excerpts.empty()},
            {"excerpts", std::move(excerpts)}};
  });
}

/// A number with its interval and the problems it is from: "7 % [2, 21]".
std::string solved_text(const Choice& choice) {
  std::string text = fmt::format("{:.0f}", 100 * choice.solved);
  if (choice.lower && choice.upper) {
    text += fmt::format(" [{:.0f}, {:.0f}]", 100 * *choice.lower, 100 * *choice.upper);
  }
  return text;
}

std::string extent_text(const Extent& extent) {
  return extent.least == extent.most ? fmt::format("{}", extent.most)
                                     : fmt::format("{} to {}", extent.least, extent.most);
}

/// The first entry of each situation, for readers without scripts.
Json chooser_rows(const Chooser& chooser) {
  return report::list_of(chooser.situations, [&](const Situation& one) -> Json {
    const Choice& first = one.entries.front();
    const auto trouble = std::ranges::find_if(chooser.troubles, [&](const Trouble& known) {
      return known.perturbation == one.perturbation;
    });
    return {{"family", one.family},
            {"folder", one.folder},
            {"problems", one.problems},
            {"variables", extent_text(one.variables)},
            {"constraints", one.constraints.most > 0},
            {"budget", one.budget},
            {"trouble", trouble == chooser.troubles.end() ? "" : trouble->words},
            {"entry", first.solver + ", " + first.formulation},
            {"gradient", first.gradient},
            {"solved", solved_text(first)},
            {"best", first.best ? fmt::format("{:.2f}", *first.best) : "–"},
            {"random", one.random ? Json(fmt::format("{:.2g}", *one.random)) : Json()}};
  });
}

/// A script for each noun, in the order of their use.
Json scripts() {
  using namespace embedded;
  return {chart_data_script,       chart_axes_script,     front_data_script,  front_chart_script,
          front_chooser_script,    front_accuracy_script, front_board_script, front_curves_script,
          front_comparison_script, front_motion_script,   front_pairs_script};
}

/// Removes repeated empty lines, which sections of a template leave behind.
std::string without_gaps(std::string text) {
  for (std::size_t at = text.find("\n\n\n"); at != std::string::npos;
       at = text.find("\n\n\n", at)) {
    text.erase(at, 1);
  }
  return text;
}

/// Returns the data for the texts of the page.
Json told(const Front& front, std::string (*write)(std::string_view)) {
  Json page = {{"answer", front.answers},
               {"has_chooser", front.chooser && !front.chooser->situations.empty()},
               {"choices", front.chooser ? chooser_rows(*front.chooser) : Json::array()},
               {"troubles", front.chooser ? Json(front.chooser->troubles) : Json::array()},
               {"runs", fmt::format("{}", front.runs)},
               {"problems", front.problems},
               {"solvers", front.solvers},
               {"has_comparison", front.comparison.has_value()},
               {"has_motion", front.motion.has_value()},
               {"has_pairs", front.pairs.has_value()},
               {"has_questions", !front.question.empty()},
               {"has_missing", !front.missing.empty()},
               {"pairs_finding", front.pairs ? Json(finding_of(*front.pairs)) : Json()},
               {"answers", answers(front)},
               {"question", front.question},
               {"entries", report::list_of(front.entries, excerpt_data)},
               {"cards", front.cards},
               {"missing", front.missing}};
  return written(page, write);
}

}  // namespace

FrontPage front_page(const Front& front, const std::string& navigation) {
  const Json shown = {{"chooser", front.chooser},
                      {"comparison", front.comparison},
                      {"motion", front.motion},
                      {"pairs", front.pairs}};
  Json page = told(front, report::escape_html);
  page["navigation"] = navigation;
  std::vector<std::string> failures;
  const auto drawn = [&failures](const report::Chart& chart) {
    const report::DrawnChart own = report::draw(chart);
    if (!own.is_drawn()) failures.push_back(report::failure_of(own));
    return report::html_of(chart, own);
  };
  page["charts"] = report::list_of(front_charts(front), drawn);
  page["has_charts"] = !page["charts"].empty();
  page["regimes"] = nullptr;
  if (front.machines) {
    page["regimes"] = drawn(regimes_chart(*front.machines));
    page["groups"] = report::escape_html(groups_sentence(*front.machines));
  }
  page["pairs_chart"] = nullptr;
  if (front.pairs) page["pairs_chart"] = drawn(pairs_chart(*front.pairs));
  page["look"] = embedded::look;
  page["data"] = report::json_in_script(report::data_text(shown));
  page["scripts"] = scripts();
  const Json summary = told(front, report::escape_markdown);
  Json data = front;
  data["report"] = "site";
  return {
      {{"index.html", report::filled(embedded::front_template, {&page})},
       {"summary.md", without_gaps(report::filled(embedded::front_summary_template, {&summary}))},
       {"data.json", report::data_text(data)}},
      std::move(failures)};
}

}  // namespace ricochet::site
