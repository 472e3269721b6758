#include "src/site/card.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::site {
namespace {

constexpr std::string_view found = "Found:";

/// Up to a full stop, or the like, that a space and a capital follow.
std::string first_sentence(const std::string& text) {
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    const bool ends = text[i] == '.' || text[i] == '!' || text[i] == '?';
    if (ends && text[i + 1] == ' ' && std::isupper(static_cast<unsigned char>(text[i + 2])) != 0) {
      return text.substr(0, i + 1);
    }
  }
  return text;
}

std::vector<std::string> paragraphs_of(const report::Page& page) {
  std::vector<std::string> all = page.intro;
  for (const report::Section& section : page.sections) {
    all.insert(all.end(), section.paragraphs.begin(), section.paragraphs.end());
  }
  return all;
}

}  // namespace

std::string verdict_of(const std::vector<std::string>& paragraphs) {
  for (const std::string& paragraph : paragraphs) {
    if (!paragraph.starts_with(found)) continue;
    std::string text = paragraph.substr(found.size());
    text.erase(0, text.find_first_not_of(' '));
    text = first_sentence(text);
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
  }
  return paragraphs.empty() ? "" : first_sentence(paragraphs.front());
}

Json card_of(const FoundReport& report) {
  Json card = {{"folder", report.folder},
               {"label", label_of(report)},
               {"title", report.kind.label},
               {"verdict", ""},
               {"date", Json()},
               {"quick", false},
               {"seconds", Json()},
               {"command", report.kind.command}};
  const Json made = report.data.value("made", Json::object());
  card["date"] = made.value("date", Json());
  card["seconds"] = made.value("seconds", Json());
  card["quick"] = made.value("quick", false);
  const std::string campaign = report.data.value("campaign", "");
  if (!campaign.empty() && !campaign.starts_with("compare")) {  // a plan's; drawn once it was made
    card["command"] = "./ricochet run " + campaign;
    card["seconds"] = nullptr;
  }
  try {
    const report::Page page =
        report::drawn(report::page_template(report.kind.name), report.data).page;
    card["title"] = page.title;
    card["verdict"] = verdict_of(paragraphs_of(page));
  } catch (const std::logic_error&) {  // data of another version
    card["verdict"] = "Its data are another version's: the command makes it anew.";
  }
  return card;
}

Json missing_cards(const std::vector<FoundReport>& reports) {
  Json cards = Json::array();
  for (const ReportKind& kind : report_kinds()) {
    if (first_of(reports, kind.name) != nullptr) continue;
    cards.push_back({{"kind", kind.name}, {"question", kind.question}, {"command", kind.command}});
  }
  return cards;
}

}  // namespace ricochet::site
