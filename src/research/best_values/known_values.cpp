#include "src/research/best_values/known_values.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "problems/carrier_track/problems/default_machine.h"

namespace ricochet::studies::best_values {

using namespace carrier_track;

BestValues read_if_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {default_machine_hash(), {}};
  std::ifstream stream(file, std::ios::binary);
  return parse_best_values({std::istreambuf_iterator<char>(stream), {}}, file.string());
}

double worth(const Problem& problem, const BestKnown& best) {
  if (best.point.size() != problem.dimension()) return std::numeric_limits<double>::infinity();
  const TrueValues true_values = true_values_at(problem, best.point);
  return true_values.violation > 0 ? std::numeric_limits<double>::infinity()
                                   : true_values.objective;
}

std::string finder_of(const RunRecord& record) {
  return fmt::format("{}, seed {}, {} of {} evaluations", record.solver, record.seed,
                     record.trace.back().evaluations, record.budget.evaluations);
}

BestValues known_values(const std::vector<Problem>& problems, const std::filesystem::path& file) {
  BestValues known{default_machine_hash(), {}};
  const BestValues in_file = read_if_there(file);
  for (const Problem& problem : problems) {
    std::vector<BestKnown> candidates;
    if (problem.best_point) candidates.push_back({0, *problem.best_point, problem.provenance});
    const auto found = in_file.of.find(problem.name);
    if (found != in_file.of.end()) candidates.push_back(found->second);
    for (BestKnown& best : candidates) {
      best.value = worth(problem, best);
      const auto before = known.of.find(problem.name);
      const double so_far =
          before == known.of.end() ? std::numeric_limits<double>::infinity() : before->second.value;
      if (best.value <= so_far) known.of.insert_or_assign(problem.name, best);
    }
  }
  return known;
}

}  // namespace ricochet::studies::best_values
