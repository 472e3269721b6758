#include "src/site/competitors.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "src/site/answers.h"
#include "src/site/rounded.h"

namespace ricochet::site {
namespace {

/// Family, budget, solver, form.
using Key = std::tuple<std::string, double, std::string, std::string>;

/// Rows of all families together have no budget.
Key key_of(const std::string& family, const Json& budget, const Json& row) {
  return {family, budget.is_number() ? budget.get<double>() : 0,
          row.at("solver").get<std::string>(), row.at("form").get<std::string>()};
}

/// Of a family and budget; the others are in the contest's report.
constexpr std::size_t always_shown = 15;

/// The columns of speed against accuracy, and where a row of the contest has them.
constexpr const char* speed_accuracy_columns[][2] = {
    {"evaluations", "/evaluations"},  {"seconds", "/seconds"},          {"solved", "/share"},
    {"solved_lower", "/share_lower"}, {"solved_upper", "/share_upper"}, {"error", "/regret"},
    {"error_lower", "/regret_lower"}, {"error_upper", "/regret_upper"},
};

Json columns() {
  Json names = {"family",  "budget", "place", "solver", "form",  "outside", "best",
                "targets", "lower",  "upper", "found",  "never", "rank"};
  for (const auto& [name, path] : speed_accuracy_columns) names.push_back(name);
  names.push_back("complete");
  return names;
}

std::map<Key, Json> speed_accuracy_of(const Json& contest) {
  std::map<Key, Json> rows;
  for (const Json& row : contest.value("speed_accuracy", Json::array())) {
    rows[key_of(row.at("family").get<std::string>(), row.at("budget"), row)] = row;
  }
  return rows;
}

/// Of numbers of the questions: the least and the most.
Json extent(const Json& questions, const char* key) {
  Json least, most;
  for (const Json& question : questions) {
    const Json& number = question.at(key);
    if (least.is_null() || number < least) least = number;
    if (most.is_null() || number > most) most = number;
  }
  return {{"least", least}, {"most", most}};
}

/// What the selector says of all families.
Json all_together(const Json& groups) {
  Json questions = Json::array();
  for (const Json& group : groups) {
    for (const Json& question : group.at("questions")) questions.push_back(question);
  }
  return {{"name", "all"},
          {"questions", questions.size()},
          {"variables", extent(questions, "variables")},
          {"constraints", extent(questions, "constraints")}};
}

class Table {
 public:
  explicit Table(const Json& contest) : fast_(speed_accuracy_of(contest)) {
    for (const Json& solver : contest.value("solvers", Json::array())) {
      if (solver.value("outside", false)) outside_.insert(solver.at("name").get<std::string>());
    }
  }

  void add(std::size_t family, const std::string& name, const Json& budget) {
    std::size_t place = 0;
    for (const Json& rating : budget.at("ratings")) {
      const Key key = key_of(name, budget.at("budget"), rating);
      ++place;
      if (place > always_shown && !fast_.contains(key) && !is_outside(rating["solver"])) continue;
      Json row = {family,
                  budget["budget"],
                  place,
                  rating.at("solver"),
                  rating.at("form"),
                  is_outside(rating["solver"])};
      for (const char* member : {"best", "share", "lower", "upper", "found", "never", "rank"}) {
        row.push_back(rounded(rating.at(member)));
      }
      append_speed_accuracy(key, row);
      rows_.push_back(std::move(row));
    }
  }

  /// The rows of all families together, which have no ratings: by the share solved, then by the
  /// evaluations until there. Returns whether there are any.
  bool add_all(std::size_t family) {
    std::vector<std::pair<Key, Json>> joint;
    for (const auto& [key, row] : fast_) {
      if (row.at("budget").is_null()) joint.emplace_back(key, row);
    }
    std::sort(joint.begin(), joint.end(), [](const auto& a, const auto& b) {
      if (a.second["share"] != b.second["share"]) return a.second["share"] > b.second["share"];
      return a.second["evaluations"] < b.second["evaluations"];
    });
    std::size_t place = 0;
    for (const auto& [key, found] : joint) {
      Json row = {family, 0, ++place, found["solver"], found["form"], is_outside(found["solver"])};
      for (int missing = 0; missing < 4; ++missing) row.push_back(nullptr);  // best, targets
      row.push_back(rounded(found["share"]));
      row.push_back(nullptr);  // never
      row.push_back(place);    // rank
      append_speed_accuracy(key, row);
      rows_.push_back(std::move(row));
    }
    return !joint.empty();
  }

  const Json& rows() const { return rows_; }

 private:
  void append_speed_accuracy(const Key& key, Json& row) const {
    const auto found = fast_.find(key);
    for (const auto& [name, path] : speed_accuracy_columns) {
      const Json::json_pointer place(path);
      row.push_back(found != fast_.end() && found->second.contains(place)
                        ? rounded(found->second.at(place))
                        : Json());
    }
    row.push_back(found != fast_.end() && found->second.value("complete", false));
  }

  bool is_outside(const Json& solver) const { return outside_.contains(solver.get<std::string>()); }

  std::map<Key, Json> fast_;
  std::set<std::string> outside_;
  Json rows_ = Json::array();
};

void append_curves(std::size_t family, const Json& budget, Json& curves) {
  for (const Json& competitor : budget.value("first", Json::array())) {
    Json points = Json::array();
    for (const Json& step : competitor.at("progress")) {
      const Json share = rounded(step.at("share"));
      if (points.size() > 1 && points.back()[1] == share && points[points.size() - 2][1] == share) {
        points.erase(points.size() - 1);  // level: its ends are enough
      }
      points.push_back({rounded(step.at("evaluations")), share});
    }
    curves.push_back({{"family", family},
                      {"budget", budget.at("budget")},
                      {"solver", competitor.at("solver")},
                      {"form", competitor.at("form")},
                      {"points", points}});
  }
}

}  // namespace

Json contest_data(const std::vector<FoundReport>& reports) {
  const FoundReport* contest = largest_contest(reports);
  if (contest == nullptr) return nullptr;
  Json families = Json::array(), curves = Json::array();
  Table table(contest->data);
  if (table.add_all(0)) families.push_back(all_together(contest->data.at("groups")));
  for (const Json& group : contest->data.at("groups")) {
    const std::string name = group.at("family");
    for (const Json& budget : group.at("budgets")) {
      table.add(families.size(), name, budget);
      append_curves(families.size(), budget, curves);
    }
    families.push_back({{"name", name},
                        {"questions", group.at("questions").size()},
                        {"variables", extent(group["questions"], "variables")},
                        {"constraints", extent(group["questions"], "constraints")}});
  }
  return {{"folder", contest->folder},
          {"families", families},
          {"columns", columns()},
          {"rows", table.rows()},
          {"curves", std::move(curves)}};
}

}  // namespace ricochet::site
