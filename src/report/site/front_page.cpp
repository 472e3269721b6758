#include "src/report/site/front_page.h"

#include "embedded/chart_library.h"
#include "embedded/front_script.h"
#include "embedded/front_summary_template.h"
#include "embedded/front_template.h"
#include "embedded/look.h"
#include "src/report/data_text.h"
#include "src/report/drawn_chart.h"
#include "src/report/filled_text.h"
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

/// JSON in which "</script>" cannot occur.
std::string inside_a_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

/// A question at the top of the page.
struct Topic {
  const char *id, *question;
  const char* none;  ///< shown if there are no excerpts
  const char* invitation;
  std::vector<const char*> commands;
  std::vector<FrontExcerpt> Front::*excerpts;
};

const Topic topics[] = {
    {"speed",
     "How fast may it turn?",
     "Not computed yet: ./ricochet reproduce",
     "A machine of your own:",
     {"./ricochet machine new > machine.toml", "./ricochet machine advise machine.toml"},
     &Front::speed},
    {"solver",
     "Which solver, when?",
     "No solvers compared yet: ./ricochet compare",
     "",
     {},
     &Front::solver},
    {"own",
     "Where does your solver stand?",
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
  Json page = {{"has_comparison", front.comparison.has_value()},
               {"has_motion", front.motion.has_value()},
               {"has_pairs", front.pairs.has_value()},
               {"has_questions", !front.question.empty()},
               {"has_missing", !front.missing.empty()},
               {"pairs_finding", front.pairs ? Json(finding_of(*front.pairs)) : Json()},
               {"answers", answers(front)},
               {"question", front.question},
               {"entries", front.entries},
               {"cards", front.cards},
               {"missing", front.missing}};
  return written(page, write);
}

}  // namespace

FrontPage front_page(const Front& front, const std::string& navigation) {
  const Json shown = {
      {"comparison", front.comparison}, {"motion", front.motion}, {"pairs", front.pairs}};
  Json page = told(front, report::escape_html);
  page["navigation"] = navigation;
  std::vector<std::string> failures;
  const auto drawn = [&failures](const report::Chart& chart) {
    const report::DrawnChart own = report::draw(chart);
    if (!own.is_drawn()) failures.push_back(report::failure_of(own));
    return report::html_of(own);
  };
  page["charts"] = report::list_of(front_charts(front), drawn);
  page["has_charts"] = !page["charts"].empty();
  page["pairs_chart"] = nullptr;
  if (front.pairs) page["pairs_chart"] = drawn(pairs_chart(*front.pairs));
  page["look"] = embedded::look;
  page["data"] = inside_a_script(report::data_text(shown));
  page["chart_library"] = embedded::chart_library;
  page["script"] = embedded::front_script;
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
