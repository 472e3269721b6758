#include "src/report/site/entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>
#include <tuple>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/report/markdown_page.h"
#include "src/report/page_template.h"
#include "src/report/text.h"

namespace ricochet::site {

namespace {

/// For each family and budget; the others are in the report.
constexpr std::size_t always_shown = 15;

/// Family, budget, solver, formulation.
using Key = std::tuple<std::string, double, std::string, std::string>;

Extent extent(const std::vector<FamilyProblem>& problems, std::int64_t FamilyProblem::*number) {
  const auto [least, most] = std::ranges::minmax_element(problems, {}, number);
  return least == problems.end() ? Extent{0, 0} : Extent{(*least).*number, (*most).*number};
}

class Table {
 public:
  explicit Table(const ComparisonData& data) {
    for (const SpeedAccuracy& one : data.speed_accuracy) {
      fast_[{one.family, one.budget.value_or(0), one.solver, one.formulation}] = one;
    }
    for (const NamedSolver& solver : data.solvers) {
      if (solver.outside) outside_.insert(solver.name);
    }
  }

  void add(std::size_t family, const std::string& name, const RatedBudget& budget) {
    std::size_t place = 0;
    for (const Rating& rating : budget.ratings) {
      const auto fast = fast_.find({name, budget.budget, rating.solver, rating.formulation});
      const bool outside = outside_.contains(rating.solver);
      if (++place > always_shown && fast == fast_.end() && !outside) continue;
      Entry entry{.family = family,
                  .budget = budget.budget,
                  .place = place,
                  .of = budget.ratings.size(),
                  .solver = rating.solver,
                  .formulation = rating.formulation,
                  .outside = outside,
                  .best = rating.best,
                  .targets = rating.share,
                  .lower = rating.lower,
                  .upper = rating.upper,
                  .returned = rating.returned,
                  .never = rating.never,
                  .rank = rating.rank};
      if (fast != fast_.end()) measure(fast->second, entry);
      entries.push_back(std::move(entry));
    }
  }

  /// Adds the entries of all families together, which have no ratings: sorted by the share solved,
  /// then by evaluations. Returns the number of problems that the first takes, `usual` if the data
  /// lack it; nothing if there are no entries.
  std::optional<std::size_t> add_all(std::size_t family, std::size_t usual) {
    std::vector<SpeedAccuracy> joint;
    for (const auto& [key, one] : fast_) {
      if (!one.budget) joint.push_back(one);
    }
    std::ranges::sort(joint, [](const SpeedAccuracy& a, const SpeedAccuracy& b) {
      return a.share != b.share ? a.share > b.share : a.evaluations < b.evaluations;
    });
    std::size_t place = 0;
    for (const SpeedAccuracy& one : joint) {
      Entry entry{.family = family,
                  .place = ++place,
                  .of = joint.size(),
                  .solver = one.solver,
                  .formulation = one.formulation,
                  .outside = outside_.contains(one.solver),
                  .returned = one.share,
                  .rank = static_cast<double>(place)};
      measure(one, entry);
      entries.push_back(std::move(entry));
    }
    if (joint.empty()) return std::nullopt;
    return joint.front().problems ? static_cast<std::size_t>(*joint.front().problems) : usual;
  }

  std::vector<Entry> entries;

 private:
  static void measure(const SpeedAccuracy& from, Entry& entry) {
    entry.evaluations = from.evaluations;
    entry.seconds = from.seconds;
    entry.solved = from.share;
    entry.solved_lower = from.share_lower;
    entry.solved_upper = from.share_upper;
    entry.error = from.optimality_gap;
    entry.error_lower = from.optimality_gap_lower;
    entry.error_upper = from.optimality_gap_upper;
    entry.complete = from.complete;
  }

  std::map<Key, SpeedAccuracy> fast_;
  std::set<std::string> outside_;
};

Curve curve_of(std::size_t family, double budget, const Progress& first) {
  Curve curve{family, budget, first.solver, first.formulation, {}};
  auto& points = curve.points;
  if (!first.progress.empty()) points.push_back({first.progress.front().evaluations, 0});
  for (const Step& step : first.progress) {
    const bool level = points.size() > 1 && points.back()[1] == step.share &&
                       points[points.size() - 2][1] == step.share;
    if (level) points.pop_back();  // its ends suffice
    points.push_back({step.evaluations, step.share});
  }
  return curve;
}

}  // namespace

FamilySize size_of(const std::string& name, const std::vector<FamilyProblem>& problems) {
  return {name, problems.size(), extent(problems, &FamilyProblem::variables),
          extent(problems, &FamilyProblem::constraints)};
}

Comparison comparison_of(const FoundReport& report) {
  Comparison comparison{report.folder, {}, {}, {}, {}};
  const auto data = report.data.get<ComparisonData>();
  for (const NamedSolver& solver : data.solvers) {
    if (solver.kind) comparison.kinds[solver.name] = *solver.kind;
  }
  Table table(data);
  std::vector<FamilyData> families;
  std::vector<FamilyProblem> problems;
  for (const FoundPage& page : report.pages) {
    if (!holds(page.headline, "family")) continue;
    const FamilyData& family = families.emplace_back(page.data.get<FamilyData>());
    problems.insert(problems.end(), family.problems.begin(), family.problems.end());
  }
  if (const auto all = table.add_all(0, problems.size())) {
    comparison.families.push_back(size_of("all", problems));
    comparison.families.back().problems = *all;
  }
  for (const FamilyData& family : families) {
    const std::size_t number = comparison.families.size();
    for (const RatedBudget& budget : family.budgets) {
      table.add(number, family.family, budget);
      for (const Progress& first : budget.first) {
        comparison.curves.push_back(curve_of(number, budget.budget, first));
      }
      for (const Progress& paper : budget.paper.value_or(std::vector<Progress>())) {
        comparison.curves.push_back(curve_of(number, budget.budget, paper));
      }
    }
    comparison.families.push_back(size_of(family.family, family.problems));
  }
  comparison.entries = std::move(table.entries);
  return comparison;
}

const FoundReport* largest_comparison(const std::vector<FoundReport>& reports) {
  const FoundReport* largest = nullptr;
  const auto runs = [](const FoundReport& r) {
    const Json number = r.data.value("runs", Json());
    return number.is_number() ? number.get<std::int64_t>() : 0;
  };
  for (const FoundReport& report : reports) {
    if (!holds(report.headline, "entries")) continue;
    if (largest == nullptr || runs(report) > runs(*largest)) largest = &report;
  }
  return largest;
}

namespace {

namespace fs = std::filesystem;

/// Reads the data of a folder. Nothing if they cannot be read.
std::optional<Json> data_of(const fs::path& folder) {
  try {
    return report::data_in(text_of_file(folder / "data.json"));
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  } catch (const std::logic_error&) {  // nested too deeply
    return std::nullopt;
  }
}

/// Reads a struct at a key. Nothing if it is missing or of another type.
template <class T>
std::optional<T> read(const Json& data, const char* key) {
  try {
    return data.at(key).get<T>();
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

/// The headline of a page of Markdown.
std::optional<report::Headline> headline_of(const report::PageSource& page, const Json& data) {
  try {
    const report::Results results = report::results_of(data);
    const auto key = [&](const char* name) {
      const auto found = page.keys.find(name);
      return found == page.keys.end() ? "" : report::filled_line(found->second, results);
    };
    report::Headline headline{};
    headline.version = report::headline_version;
    headline.title = report::title_of(page, results);
    headline.finding = key("finding");
    headline.command = key("made_by");
    if (!page.keys.contains("command")) {
      headline.group = key("group");
      headline.label = key("label");
    }
    return headline;
  } catch (const std::exception&) {  // the page needs data that are missing
    return std::nullopt;
  }
}

/// Reads the headline with the parts repeated from the page. Nothing if the data are of another
/// version.
std::optional<report::Headline> headline_of(const Json& data) {
  if (const auto kind = read<std::string>(data, "report")) {
    for (const std::string& known : report::page_names()) {
      const std::string sheet = report::page_template(known);
      if (known == *kind && report::is_page_source(sheet))
        return headline_of(report::page_source(sheet), data);
    }
  }
  const auto kept = read<report::Headline>(data, "headline");
  if (!kept || kept->version != report::headline_version) return std::nullopt;
  try {
    return report::headline_in(report::page_template(data.at("report")), data);
  } catch (const std::exception&) {  // the template needs data that are missing
    return std::nullopt;
  }
}

/// The names of further pages; those that may lead out of the folder are left out.
std::vector<std::string> pages_in(const Json& data) {
  auto pages = read<std::vector<std::string>>(data, "pages").value_or(std::vector<std::string>());
  std::erase_if(pages, [](const std::string& page) { return !is_name(page); });
  return pages;
}

FoundReport found(const fs::path& folder, const report::ReportKind& kind, Json data) {
  FoundReport report{folder.filename().string(), kind, read<Made>(data, "made").value_or(Made{}),
                     headline_of(data),          {},   {}};
  const std::vector<std::string> pages = pages_in(data);
  report.data = std::move(data);
  for (const std::string& page : pages) {
    Json own = data_of(folder / page).value_or(Json::object());
    std::vector<std::string> further = pages_in(own);
    report.pages.push_back({page, headline_of(own), std::move(own), std::move(further)});
  }
  return report;
}

/// The data in the subfolders, except for those of sites; nothing where they cannot be read.
std::map<std::string, std::optional<Json>> data_below(const fs::path& site) {
  std::map<std::string, std::optional<Json>> all;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(site, none)) {
    if (!fs::is_regular_file(entry.path() / "data.json", none)) continue;
    std::optional<Json> data = data_of(entry.path());
    if (data && data->is_object() && data->value("report", Json()) == "site") continue;
    all[entry.path().filename().string()] = std::move(data);
  }
  return all;
}

}  // namespace

std::vector<std::string> folders_of_data(const fs::path& site) {
  std::vector<std::string> folders;
  for (const auto& [folder, data] : data_below(site)) folders.push_back(folder);
  return folders;
}

std::vector<FoundReport> found_reports(const fs::path& site) {
  const std::map<std::string, std::optional<Json>> data = data_below(site);
  std::vector<FoundReport> reports;
  for (const report::ReportKind& kind : report::report_kinds()) {
    for (const auto& [folder, own] : data) {
      if (!own || !own->is_object()) continue;
      if (own->value("report", Json()) == kind.name) {
        reports.push_back(found(site / folder, kind, *own));
      }
    }
  }
  return reports;
}

std::string label_of(const FoundReport& report) {
  if (report.folder == report.kind.name) return report.kind.label;
  return fmt::format("{}: {}", report.kind.label, report.folder);
}

bool holds(const std::optional<report::Headline>& headline, const std::string& what) {
  return headline && std::ranges::count(headline->holds, what) > 0;
}

}  // namespace ricochet::site
