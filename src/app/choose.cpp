#include <fmt/format.h>

#include <algorithm>

#include "problems/own/own_problem.h"
#include "ricochet/error.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/app/problem_choice.h"
#include "src/report/text.h"
#include "src/studies/choice/choice.h"

namespace ricochet::cli {

namespace {

using namespace studies::choice;
using report::Json;

constexpr std::size_t shown_entries = 5;

struct ChooseOptions {
  ProblemChoice problem;                          ///< without a name: the report
  std::vector<std::string> stores = {"archive"};  ///< runs that it is measured on
  std::int64_t budget = 1000;                     ///< evaluations
  bool json = false;
};

std::vector<Evidence> evidence_in(const std::vector<std::string>& stores) {
  std::vector<Evidence> all;
  for (const std::string& name : stores) {
    const Store store = Store::open(archive_named(name), Store::For::reading);
    FinishedCampaign finished = finished_campaign(store);
    all.push_back({plan_from(store.description().plan, name).name, std::move(finished.campaign),
                   std::move(finished.results)});
  }
  return all;
}

/// The facts by which the rule chooses.
Json facts_of(const Evaluator& evaluator, const Problem& problem) {
  return {{"variables", problem.dimension()},
          {"equalities", problem.equalities},
          {"inequalities", evaluator.constraints() - problem.equalities},
          {"derivatives", evaluator.has_derivatives()},
          {"gradient_price", evaluator.gradient_price()},
          {"residuals", evaluator.has_residuals()},
          {"surrogate", evaluator.has_smoothing()},
          {"jumps", evaluator.jumps()},
          {"budget", evaluator.budget().evaluations}};
}

/// What the runs say of one line: how many problems, what the choice solves, who is first.
Json said_by(const Evidence& evidence, const Setting& setting, const RuleLine& line) {
  const std::vector<Case> cases =
      only(cases_of(evidence, setting), [&](const Case& each) { return each.line == &line; });
  Json said = {{"runs", evidence.name}, {"setting", setting.title}, {"problems", cases.size()}};
  if (cases.empty()) return said;
  for (const auto& [family, places] : by_family(cases)) said["families"].push_back(family);
  said["solved"] = mean_over_families(all_of(cases), chosen_shares(cases));
  const std::vector<Standing> order = standings(cases);
  const std::vector<double> first = probabilities_of_being_first(cases, order);
  for (std::size_t i = 0; i < std::min(shown_entries, order.size()); ++i) {
    said["entries"].push_back({{"entry", order[i].entry},
                               {"solved", order[i].mean},
                               {"probability_of_being_first", first[i]}});
  }
  return said;
}

std::string in_words(const Json& answer) {
  std::string text =
      fmt::format("{} for {}: {}.\nThe line of the rule: {}.\n",
                  answer["solver"].get<std::string>(), answer["problem"].get<std::string>(),
                  answer["reason"].get<std::string>(), answer["declared"].get<std::string>());
  for (const Json& said : answer["evidence"]) {
    const std::string of =
        fmt::format("{}, {}", said["runs"].get<std::string>(), said["setting"].get<std::string>());
    if (!said.contains("entries")) {
      text += fmt::format("{}: no problem of this kind.\n", of);
      continue;
    }
    text += fmt::format(
        "{}: on {} of {} it solves {:.0f} % of the runs. The first there, and what else to try:\n",
        of, report::counted(said["problems"].get<std::size_t>(), "problem"),
        report::counted(said["families"].size(), "family", "families"),
        100 * said["solved"].get<double>());
    for (const Json& each : said["entries"]) {
      text += fmt::format("  {:48} {:3.0f} %  P(first) {:.2f}\n", each["entry"].get<std::string>(),
                          100 * each["solved"].get<double>(),
                          each["probability_of_being_first"].get<double>());
    }
  }
  return text;
}

/// What "auto" would run on a problem. Evaluates nothing, and starts no program.
int choose_for(const ChooseOptions& options) {
  std::optional<own::OwnProblem> own;
  if (own::is_problem_file(options.problem.name)) {
    own.emplace(own::read_problem_file(options.problem.name));
  }
  const Problem problem = own ? own->problem() : choose_problem(options.problem, "choose").problem;
  Budget budget{options.budget};
  budget.gradient_price = problem.gradient_cost;
  const Evaluator evaluator(problem, budget);
  const std::optional<Choice> choice = choice_of(evaluator, all_solvers());
  if (!choice) throw InputError(problem.name + ": this build has no solver that auto would choose");
  Json answer = {{"problem", problem.name},        {"solver", choice->solver},
                 {"line", choice->line->name},     {"declared", choice->line->declared},
                 {"reason", choice->line->reason}, {"facts", facts_of(evaluator, problem)},
                 {"evidence", Json::array()}};
  for (const Evidence& evidence : evidence_in(options.stores)) {
    answer["evidence"].push_back(said_by(evidence, setting_of(problem), *choice->line));
  }
  fmt::print("{}", options.json ? answer.dump(2) + "\n" : in_words(answer));
  return 0;
}

int choose(const ChooseOptions& options, const std::string& out) {
  check_budget(options.budget);
  if (!options.problem.name.empty()) return choose_for(options);
  tell(studies::run(choice_study(evidence_in(options.stores)), false, out));
  return 0;
}

}  // namespace

void add_choose(CommandLine& line) {
  CLI::App* command =
      line.add("choose", "Say which solver auto would run on a problem, why, and what else to try",
               "  ricochet choose mine.toml --budget 500\n"
               "  ricochet choose design-count-C1\n"
               "  ricochet choose  # how good the choice is, as a report");
  const auto options = std::make_shared<ChooseOptions>();
  add_problem_choice(command, options->problem);
  command->get_option("problem")->required(false);
  add_value(command, "--store", options->stores, "Runs that the choice is measured on", "ARCHIVE");
  add_value(command, "--budget", options->budget, "Evaluations");
  add_format(command, options->json);
  const auto study = add_study_options(command, {"choice", "", nullptr});
  line.on_call(command, [options, study] { return choose(*options, study->out); });
}

}  // namespace ricochet::cli
