#include "src/benchmark/experiment/campaign/record_text.h"

#include <nlohmann/json.hpp>
#include <optional>

namespace ricochet {
namespace {

using Json = nlohmann::json;

std::string bytes_of(const Json& json) {
  std::string bytes;
  Json::to_cbor(json, nlohmann::detail::output_adapter<char>(bytes));
  return bytes;
}

Json json_of(const Vector& x) {
  return std::vector<double>(x.begin(), x.end());
}

Vector vector_from(const Json& json) {
  const auto numbers = json.get<std::vector<double>>();
  return Eigen::Map<const Vector>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

Json json_of(const TrueValues& true_values) {
  return {true_values.objective, true_values.violation};
}

TrueValues true_values_from(const Json& json) {
  return {json.at(0), json.at(1)};
}

Json json_of(const Improvement& step) {
  return {step.evaluations, step.seconds, json_of(step.true_values), json_of(step.x)};
}

Improvement step_from(const Json& json) {
  return {json.at(0), json.at(1), true_values_from(json.at(2)), vector_from(json.at(3))};
}

Json json_of(const SolverTermination& exit) {
  return {exit.reason, exit.point ? json_of(*exit.point) : Json()};
}

SolverTermination exit_from(const Json& json) {
  SolverTermination exit{json.at(0)};
  if (!json.at(1).is_null()) exit.point = vector_from(json.at(1));
  return exit;
}

template <class List>
Json array_of(const List& list) {
  Json all = Json::array();
  for (const auto& entry : list) all.push_back(json_of(entry));
  return all;
}

}  // namespace

std::string text_of(const Improvement& improvement) {
  return bytes_of(json_of(improvement));
}

Improvement improvement_from(const std::string& text) {
  return step_from(Json::from_cbor(text));
}

std::string text_of(const RunRecord& record) {
  const Ledger& ledger = record.ledger;
  Json json = {{"problem", record.problem},
               {"solver", record.solver},
               {"instance", record.instance},
               {"run", record.run},
               {"seed", record.seed},
               {"evaluations", record.budget.evaluations},
               {"seconds", record.budget.seconds},
               {"ledger",
                {ledger.values, ledger.derivatives, ledger.hessians, ledger.charged, ledger.refused,
                 ledger.seconds}},
               {"termination_reason", static_cast<int>(record.termination_reason)},
               {"terminations", array_of(record.terminations)},
               {"failure", record.failure},
               {"trace", array_of(record.trace)}};
  if (const auto& price = record.budget.gradient_price) json["gradient_price"] = *price;
  if (const auto& over = record.returned) {
    json["returned"] = {json_of(over->x), json_of(over->true_values)};
  }
  return bytes_of(json);
}

RunRecord record_from(const std::string& text) {
  const Json json = Json::from_cbor(text);
  const Json& ledger = json.at("ledger");
  RunRecord record;
  record.problem = json.at("problem");
  record.solver = json.at("solver");
  record.instance = json.at("instance");
  record.run = json.at("run");
  record.seed = json.at("seed");
  record.budget = {json.at("evaluations"), json.at("seconds")};
  if (json.contains("gradient_price")) record.budget.gradient_price = json["gradient_price"];
  record.ledger = {ledger.at(0), ledger.at(1), ledger.at(2),
                   ledger.at(3), ledger.at(4), ledger.at(5)};
  record.termination_reason =
      static_cast<TerminationReason>(json.at("termination_reason").get<int>());
  for (const Json& exit : json.at("terminations")) record.terminations.push_back(exit_from(exit));
  record.failure = json.at("failure");
  for (const Json& step : json.at("trace")) record.trace.push_back(step_from(step));
  if (json.contains("returned")) {
    const Json& over = json["returned"];
    record.returned = {vector_from(over.at(0)), true_values_from(over.at(1))};
  }
  return record;
}

}  // namespace ricochet
