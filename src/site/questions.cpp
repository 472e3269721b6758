#include "src/site/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "src/site/answers.h"

namespace ricochet::site {
namespace {

Json link_to(const std::string& text, const std::string& page, const std::string& anchor) {
  return {{"text", text}, {"page", page}, {"anchor", anchor}};
}

std::string percent(const Json& share) {
  return fmt::format("{:.0f} %", 100 * share.get<double>());
}

void ask_speed(const FoundReport& reproduction, Json& questions) {
  const Json& cases = reproduction.data.at("cases");
  const auto one = cases.find("C3");
  if (one == cases.end() || !one->at("threshold").is_number()) return;
  const double speed = one->at("threshold").get<double>();
  questions.push_back(
      {{"question", "How fast may C3 run?"},
       {"answer", fmt::format("{:.2f} rad/s, {:.0f} rpm.", speed, 30 / std::numbers::pi * speed)},
       {"links", {link_to("every case", reproduction.folder, "thresholds")}}});
}

/// What was asked of the solvers of a family, with one budget.
struct MeasuredLeader {
  Json leader;
  double least, most;  ///< variables
  double distance;     ///< from what is wanted, in both by the logarithms of the ratios
};

/// The nearest with fewer variables, with as many, and with more.
struct NearestLeaders {
  std::optional<MeasuredLeader> below, at, above;
};

NearestLeaders nearest_to(const FoundReport& contest, double variables, double evaluations) {
  NearestLeaders nearest;
  for (const Json& leader : contest.data.value("leaders", Json::array())) {
    MeasuredLeader one{leader, 0, 0, 0};
    for (const Json& group : contest.data.value("groups", Json::array())) {
      if (group.at("family") != leader.at("family")) continue;
      for (const Json& question : group.at("questions")) {
        const double n = question.at("variables").get<double>();
        one.least = one.least == 0 ? n : std::min(one.least, n);
        one.most = std::max(one.most, n);
      }
    }
    if (one.least <= 0) continue;
    const double there = std::clamp(variables, one.least, one.most);
    one.distance =
        std::abs(std::log(there / variables)) +
        std::abs(std::log(leader.at("budget").get<double>() / (evaluations / variables)));
    auto& best = one.most < variables    ? nearest.below
                 : one.least > variables ? nearest.above
                                         : nearest.at;
    if (!best || one.distance < best->distance) best = std::move(one);
  }
  return nearest;
}

std::string told(const MeasuredLeader& one) {
  const std::string variables = one.least == one.most
                                    ? fmt::format("{}", one.most)
                                    : fmt::format("{} to {}", one.least, one.most);
  return fmt::format("{} ({} variables, {} evaluations each): {}, shown {} (P(best) {:.2f})",
                     one.leader.at("family").get<std::string>(), variables,
                     one.leader.at("budget").get<double>(),
                     one.leader.at("solver").get<std::string>(),
                     one.leader.at("form").get<std::string>(), one.leader.at("best").get<double>());
}

void ask_solver(const FoundReport& contest, Json& questions) {
  constexpr double variables = 16, evaluations = 500;
  const NearestLeaders nearest = nearest_to(contest, variables, evaluations);
  std::string answer = nearest.at ? "" : "Not measured itself; nearest: ";
  Json links = Json::array();
  const auto add = [&](const std::optional<MeasuredLeader>& one) {
    if (!one) return;
    const auto family = one->leader.at("family").get<std::string>();
    answer += (links.empty() ? "" : "; ") + told(*one);
    links.push_back(link_to(family, contest.folder + "/" + family, ""));
  };
  if (nearest.at) {
    add(nearest.at);
  } else {
    add(nearest.below);
    add(nearest.above);
  }
  if (links.empty()) return;
  questions.push_back({{"question", fmt::format("Which solver for {} variables and {} evaluations?",
                                                variables, evaluations)},
                       {"answer", answer + "."},
                       {"links", std::move(links)}});
}

void ask_gradient(const FoundReport& contest, Json& questions) {
  std::string answer;
  for (const Json& free : contest.data.value("changes", Json::array())) {
    if (free.at("changed") != "price of a gradient" || free.at("setting") != "measured") continue;
    for (const Json& dear : contest.data["changes"]) {
      if (dear.at("changed") != free["changed"] || dear.at("setting") != "n" ||
          dear.at("family") != free.at("family")) {
        continue;
      }
      answer +=
          fmt::format("{} {} to {} on {}", answer.empty() ? "" : ",", percent(dear.at("found")),
                      percent(free.at("found")), free["family"].get<std::string>());
    }
  }
  if (answer.empty()) return;
  questions.push_back({{"question", "What does a gradient buy?"},
                       {"answer",
                        "The best solver's runs solved, with gradients by differences and by what "
                        "exact ones were measured to cost:" +
                            answer + "."},
                       {"links", {link_to("prices of a gradient", contest.folder, "changes")}}});
}

void ask_failures(const FoundReport& contest, Json& questions) {
  constexpr std::size_t told_of = 3;
  const Json families = contest.data.value("families", Json::array());
  std::vector<std::pair<double, std::string>> shares;
  for (const Json& row : contest.data.value("map", Json::array())) {
    if (row.at("solver") != "ipopt") continue;
    for (std::size_t f = 0; f < families.size(); ++f) {
      if (!row.at("shares")[f].is_number()) continue;
      shares.emplace_back(row["shares"][f].get<double>(), families[f].at("family"));
    }
  }
  if (shares.empty()) return;
  std::sort(shares.begin(), shares.end());
  std::string answer;
  for (std::size_t k = 0; k < std::min(told_of, shares.size()); ++k) {
    answer += fmt::format("{}{} ({} solved)", k == 0 ? "" : ", ", shares[k].second,
                          percent(shares[k].first));
  }
  questions.push_back({{"question", "Where does Ipopt fail?"},
                       {"answer", fmt::format("Most of all on {}, of {} kinds of questions.",
                                              answer, shares.size())},
                       {"links", {link_to("who solves what", contest.folder, "map")}}});
}

void ask_planar(const FoundReport& dynamics, const std::vector<FoundReport>& reports,
                Json& questions) {
  const Json& directions = dynamics.data.at("levels").at("directions");
  if (directions.empty()) return;
  double wrong = 0;
  for (const Json& direction : directions) {
    wrong = std::max(wrong, direction.at("wrong").get<double>());
  }
  Json links = {link_to("the levels of the model", dynamics.folder, "levels")};
  for (const FoundReport& report : reports) {
    if (report.kind.name != std::string("advice")) continue;
    links.push_back(link_to("your machine", report.folder, ""));
  }
  questions.push_back(
      {{"question", "Is the planar model needed for my machine?"},
       {"answer",
        fmt::format("Only where the yarn pulls across harder than friction holds: of the paper's "
                    "cases it changes at most {} of the counts, up to a pull across of {:.2g} "
                    "times that along. Of yours ./ricochet machine advise says it.",
                    percent(wrong), directions.back().at("tangent").get<double>())},
       {"links", std::move(links)}});
}

}  // namespace

Json questions_data(const std::vector<FoundReport>& reports) {
  Json questions = Json::array();
  const FoundReport* contest = largest_contest(reports);
  if (const FoundReport* report = first_of(reports, "reproduction")) ask_speed(*report, questions);
  if (contest != nullptr) {
    ask_solver(*contest, questions);
    ask_gradient(*contest, questions);
    ask_failures(*contest, questions);
  }
  if (const FoundReport* report = first_of(reports, "dynamics")) {
    ask_planar(*report, reports, questions);
  }
  return questions;
}

}  // namespace ricochet::site
