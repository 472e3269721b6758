#include "src/core/question.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "src/core/error.h"
#include "src/core/near_names.h"
#include "src/core/penalty.h"

namespace ricochet {

std::vector<Form> Question::forms(const std::vector<double>& widths) const {
  std::vector<double> shown = {0};
  const auto add = [&](double w) {
    if (std::find(shown.begin(), shown.end(), w) == shown.end()) shown.push_back(w);
  };
  if (stated.smoothed) {
    add(width);
    for (const double w : widths) add(w);
  }
  std::vector<Form> forms;
  for (const double w : shown) {
    forms.push_back({w});
    if (stated.constraints > 0) forms.push_back({w, true});
  }
  return forms;
}

Problem Question::problem(const Form& form) const {
  if ((form.width > 0 && !stated.smoothed) || (form.penalised && stated.constraints == 0)) {
    throw std::invalid_argument(fmt::format("{} cannot be shown with width {}{}", name(),
                                            form.width, form.penalised ? ", penalised" : ""));
  }
  const Problem shown = form.width > 0 ? stated.smoothed(form.width) : stated;
  return form.penalised ? penalised(shown, penalty_weight) : shown;
}

std::string Question::name_of(const Form& form) const {
  if (!stated.smoothed) return form.penalised ? "penalised" : "as-stated";
  const std::string shown = form.width == 0       ? "count"
                            : form.width == width ? "surrogate"
                                                  : fmt::format("surrogate-{}", form.width);
  return form.penalised ? "penalised-" + shown : shown;
}

Form Question::form_named(const std::string& wanted) const {
  if (wanted.empty()) return {};
  std::vector<std::string> known;
  for (const Form& form : forms()) {
    known.push_back(name_of(form));
    if (known.back() == wanted) return form;
  }
  throw InputError(
      fmt::format("{}: {} has no such form; {}", wanted, name(), what_instead(wanted, known)));
}

}  // namespace ricochet
