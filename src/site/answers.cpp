#include "src/site/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "src/site/rounded.h"

namespace ricochet::site {
namespace {

constexpr double rpm = 30 / std::numbers::pi;  // of a rad/s

/// The least and the greatest of numbers, some of which may be missing.
class Extent {
 public:
  void add(const Json& number) {
    if (!number.is_number()) return;
    least_ = std::min(least_.value_or(number), number.get<double>());
    most_ = std::max(most_.value_or(number), number.get<double>());
  }
  Json least() const { return least_ ? Json(*least_) : Json(); }
  Json most() const { return most_ ? Json(*most_) : Json(); }
  Json as_json(double unit = 1) const {
    if (!least_) return nullptr;
    return {{"least", unit * *least_}, {"most", unit * *most_}, {"one", *least_ == *most_}};
  }

 private:
  std::optional<double> least_, most_;
};

struct SameMachine {
  std::string cases;
  Extent computed, published;
};

std::set<std::string> outside_solvers(const Json& contest) {
  std::set<std::string> names;
  for (const Json& solver : contest.value("solvers", Json::array())) {
    if (solver.value("outside", false)) names.insert(solver.at("name").get<std::string>());
  }
  return names;
}

/// Where they stand with the largest budget of a group, and of how many.
void append_places(const Json& group, const std::set<std::string>& outside, Json& places) {
  const Json& budget = group.at("budgets").back();
  std::size_t place = 0;
  for (const Json& rating : budget.at("ratings")) {
    ++place;
    if (!outside.contains(rating.at("solver").get<std::string>())) continue;
    places.push_back({{"solver", rating["solver"]},
                      {"form", rating["form"]},
                      {"family", group["family"]},
                      {"budget", budget["budget"]},
                      {"place", place},
                      {"of", budget["ratings"].size()}});
  }
}

/// Who solves what: the first solvers of the contest's map, in percent, with the family that a cell
/// leads to.
Json family_map(const FoundReport& contest) {
  constexpr std::size_t shown = 12;
  const Json families = contest.data.value("families", Json::array());
  const Json map = contest.data.value("map", Json::array());
  Json rows = Json::array();
  for (std::size_t r = 0; r < std::min(shown, map.size()); ++r) {
    Json cells = Json::array();
    for (std::size_t f = 0; f < families.size(); ++f) {
      cells.push_back({{"family", families[f].at("family")}, {"share", map[r]["shares"][f]}});
    }
    rows.push_back({{"solver", map[r].at("solver")}, {"cells", std::move(cells)}});
  }
  Json columns = Json::array();
  for (const Json& family : families) columns.push_back({{"family", family.at("family")}});
  return {{"families", families.size()},
          {"solvers", map.size()},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)}};
}

}  // namespace

const FoundReport* largest_contest(const std::vector<FoundReport>& reports) {
  const FoundReport* largest = nullptr;
  for (const FoundReport& report : reports) {
    if (report.kind.name != std::string("contest")) continue;
    const auto runs = [](const FoundReport& r) { return r.data.value("runs", 0); };
    if (largest == nullptr || runs(report) > runs(*largest)) largest = &report;
  }
  return largest;
}

Json speed_answer(const std::vector<FoundReport>& reports) {
  const FoundReport* report = first_of(reports, "reproduction");
  if (report == nullptr) return nullptr;
  std::map<std::pair<double, double>, SameMachine> machines;
  Extent all;
  const Json& cases = report->data.at("cases");
  for (const auto& [id, row] : cases.items()) {
    SameMachine& machine = machines[{row.at("restitution").get<double>(), row.at("friction")}];
    machine.cases += (machine.cases.empty() ? "" : ", ") + id;
    machine.computed.add(row.at("threshold"));
    machine.published.add(row.at("paper_threshold"));
    all.add(row.at("threshold"));
  }
  Json rows = Json::array();
  for (const auto& [constants, machine] : machines) {
    rows.push_back({{"cases", machine.cases},
                    {"restitution", constants.first},
                    {"friction", constants.second},
                    {"speed", machine.computed.as_json()},
                    {"turns", machine.computed.as_json(rpm)},
                    {"published", machine.published.as_json()}});
  }
  return {{"folder", report->folder},
          {"rows", rows},
          {"speed", all.as_json()},
          {"turns", all.as_json(rpm)}};
}

Json machine_answers(const std::vector<FoundReport>& reports) {
  Json machines = Json::array();
  for (const FoundReport& report : reports) {
    if (report.kind.name != std::string("advice")) continue;
    machines.push_back(
        {{"folder", report.folder}, {"headline", report.data.value("headline", "")}});
  }
  return machines;
}

Json solver_answer(const std::vector<FoundReport>& reports) {
  const FoundReport* contest = largest_contest(reports);
  if (contest == nullptr) return nullptr;
  Json leaders = Json::array(), places = Json::array();
  for (const Json& leader : contest->data.at("leaders")) {
    Json row;
    for (const char* key : {"family", "budget", "solver", "form", "questions"}) {
      row[key] = leader.at(key);
    }
    for (const char* key : {"best", "share", "lower", "upper"}) row[key] = rounded(leader.at(key));
    leaders.push_back(std::move(row));
  }
  const std::set<std::string> outside = outside_solvers(contest->data);
  for (const Json& group : contest->data.at("groups")) append_places(group, outside, places);
  const Json pages = contest->data.value("pages", Json::array());
  const auto has = [&](const char* page) {
    return std::find(pages.begin(), pages.end(), page) != pages.end();
  };
  return {{"folder", contest->folder},
          {"map", family_map(*contest)},
          {"across_machines", has("across-machines")},
          {"failure_atlas", has("failure-atlas")},
          {"runs", contest->data.at("runs")},
          {"leaders", leaders},
          {"places", places}};
}

}  // namespace ricochet::site
