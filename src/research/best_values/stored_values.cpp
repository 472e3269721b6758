#include "src/research/best_values/stored_values.h"

#include <limits>
#include <map>
#include <set>

#include "src/benchmark/experiment/store/store.h"
#include "src/core/instance.h"
#include "src/core/text_file.h"
#include "src/research/best_values/known_values.h"

namespace ricochet::studies::best_values {
namespace {

using namespace carrier_track;

/// The last point of a run's trace, in the problem as stated, and its value there.
BestKnown best_of(const Problem& problem, const StoredRun& run) {
  const Vector& x = run.record.trace.back().x;
  BestKnown best{0, stated_point(problem, run.key.instance, x), finder_of(run.record)};
  best.value = worth(problem, best);
  return best;
}

}  // namespace

std::size_t take_stored_values(const std::vector<Problem>& problems,
                               const std::filesystem::path& store,
                               const std::filesystem::path& file) {
  std::map<std::string, const Problem*> named;
  for (const Problem& problem : problems) named.emplace(problem.name, &problem);
  BestValues known = known_values(problems, file);
  std::set<std::string> improved;
  Store::open(store, Store::For::reading).each([&](const StoredRun& run) {
    const auto problem = named.find(run.key.cell.problem);
    if (problem == named.end() || run.record.trace.empty()) return;
    const auto before = known.of.find(problem->first);
    const double so_far =
        before == known.of.end() ? std::numeric_limits<double>::infinity() : before->second.value;
    const double least_gain = problem->second->tolerance;
    const double found = run.record.trace.back().true_values.objective;
    if (!(found < so_far - least_gain)) return;  // without an evaluation
    BestKnown best = best_of(*problem->second, run);
    if (!(best.value < so_far - least_gain)) return;
    improved.insert(problem->first);
    known.of.insert_or_assign(problem->first, std::move(best));
  });
  if (!improved.empty()) write_text_file(file, write_best_values(known));
  return improved.size();
}

}  // namespace ricochet::studies::best_values
