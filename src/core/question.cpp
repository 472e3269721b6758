#include "src/core/question.h"

#include <fmt/format.h>

#include <stdexcept>

#include "src/core/error.h"
#include "src/core/near_names.h"
#include "src/core/penalty.h"

namespace ricochet {

std::vector<Form> Question::forms() const {
  std::vector<Form> forms = {{}};
  if (stated.smoothed) forms.push_back({width});
  if (stated.constraints == 0) return forms;
  std::vector<Form> all;
  for (const Form& form : forms) {
    all.push_back(form);
    all.push_back({form.width, true});
  }
  return all;
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
