#include "src/studies/calibration/left_out.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "src/studies/calibration/appraisal.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::calibration {

namespace {

using namespace carrier_track;

/// The cases of one group have equal keys.
std::pair<double, double> key_of(const Case& c, LeftOut what) {
  return {what == LeftOut::friction ? 0 : c.restitution,
          what == LeftOut::restitution ? 0 : c.friction};
}

bool is_in(const CaseIds& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

/// Of cases of the group, by a fit.
void add_predictions(std::vector<Prediction>& all, LeftOut what, const CaseIds& ids, const Fit& fit,
                     double step) {
  for (const CaseAppraisal& c : appraise(fit, step).cases) {
    const auto& paper = c.the_case.claim.threshold;
    if (paper && (what == LeftOut::nothing || is_in(ids, c.the_case.id)))
      all.push_back({what, c.the_case.id, *paper, c.score.threshold});
  }
}

}  // namespace

const EnumNames<LeftOut>& names_of(LeftOut /*what*/) {
  static const EnumNames<LeftOut> names = {{"in the fit", LeftOut::nothing},
                                           {"without the case itself", LeftOut::one_case},
                                           {"without its machine", LeftOut::machine},
                                           {"without all of its restitution", LeftOut::restitution},
                                           {"without all of its friction", LeftOut::friction}};
  return names;
}

std::vector<CaseIds> groups_of(LeftOut what) {
  std::vector<CaseIds> groups;
  if (what == LeftOut::nothing) return groups;
  std::map<std::pair<double, double>, std::size_t> places;
  for (const Case& c : all_cases()) {
    if (what == LeftOut::one_case) {
      if (c.claim.threshold) groups.push_back({c.id});
      continue;
    }
    if (!c.claim.threshold && c.id != "C11") continue;
    const auto [place, is_new] = places.try_emplace(key_of(c, what), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(c.id);
  }
  return groups;
}

double Prediction::error() const {
  return predicted ? std::log(*predicted / paper) : std::log(2.0);
}

std::vector<Prediction> predictions(const Fit& choice, const Search& search, int searches,
                                    double step, FitStore& store) {
  const Parameterisation start = forgotten(choice.interpretation, choice.free, choice.constants);
  std::vector<std::pair<LeftOut, CaseIds>> refits;
  std::vector<FitTask> tasks;
  for (const LeftOut what : all_left_out) {
    for (const CaseIds& ids : groups_of(what)) {
      refits.emplace_back(what, ids);
      for (int k = 0; k < searches; ++k) {
        Search own = search;
        own.seed += k;
        tasks.push_back(fit_task("left out", start, own, ids));
      }
    }
  }
  const std::vector<Fit> fits = fits_by("fitting without some cases", tasks, store);
  std::vector<Prediction> all;
  add_predictions(all, LeftOut::nothing, {}, choice, step);
  auto next = fits.begin();
  for (const auto& [what, ids] : refits) {
    add_predictions(all, what, ids,
                    *std::min_element(next, next + searches,
                                      [](const Fit& a, const Fit& b) { return a.loss < b.loss; }),
                    step);
    next += searches;
  }
  return all;
}

std::vector<Prediction> predictions_without(LeftOut what, const std::vector<Prediction>& all) {
  std::vector<Prediction> some;
  std::ranges::copy_if(all, std::back_inserter(some),
                       [&](const Prediction& p) { return p.what == what; });
  return some;
}

std::vector<double> errors_of(const std::vector<Prediction>& predictions) {
  std::vector<double> errors;
  for (const Prediction& p : predictions) errors.push_back(p.error());
  return errors;
}

std::vector<std::vector<double>> errors_by_machine(const std::vector<Prediction>& predictions) {
  std::vector<std::vector<double>> groups;
  for (const CaseIds& ids : groups_of(LeftOut::machine)) {
    std::vector<double>& group = groups.emplace_back();
    for (const Prediction& p : predictions) {
      if (is_in(ids, p.case_id)) group.push_back(p.error());
    }
    if (group.empty()) groups.pop_back();
  }
  return groups;
}

}  // namespace ricochet::studies::calibration
