#include "src/studies/calibration/left_out.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "src/studies/calibration/appraisal.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::calibration {

using namespace carrier_track;

namespace {

/// The cases of one group have equal keys.
std::pair<double, double> key_of(const Case& c, LeftOut what) {
  return {what == LeftOut::friction ? 0 : c.restitution,
          what == LeftOut::restitution ? 0 : c.friction};
}

bool is_in(const CaseIds& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
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

std::vector<Prediction> predictions(const Fit& choice, Search search, int times, double step,
                                    Searches& searches) {
  std::vector<LeftOut> kinds;
  std::vector<Fit> starts;
  for (const LeftOut what : all_left_out) {
    for (const CaseIds& ids : groups_of(what)) {
      kinds.push_back(what);
      starts.push_back({forgotten(choice), 0, ids});
    }
  }
  std::vector<Fit> fits = searches.fits(starts, search);
  for (int k = 1; k < times; ++k) {
    ++search.seed;
    const std::vector<Fit> others = searches.fits(starts, search);
    for (std::size_t i = 0; i < fits.size(); ++i) fits[i] = best_of({fits[i], others[i]});
  }
  kinds.push_back(LeftOut::nothing);
  fits.push_back(choice);
  std::vector<Prediction> all;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    for (const CaseAppraisal& c : appraise(fits[i], step).cases) {
      const auto& paper = c.the_case.claim.threshold;
      if (paper && (kinds[i] == LeftOut::nothing || is_in(fits[i].left_out, c.the_case.id)))
        all.push_back({kinds[i], c.the_case.id, *paper, c.score.threshold});
    }
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
