#include "src/studies/best_values/question.h"

#include <map>
#include <stdexcept>

namespace ricochet::studies::best_values {

std::vector<Question> questions_of(const std::vector<Family>& families) {
  std::vector<Question> questions;
  struct Place {
    std::size_t first, size;
  };
  std::map<std::string, Place> places;
  for (const Family& family : families) {
    if (family.judged_as != family.name) continue;
    places[family.name] = {questions.size(), family.problems.size()};
    for (const Problem& problem : family.problems) questions.push_back({problem.name, {problem}});
  }
  for (const Family& family : families) {
    if (family.judged_as == family.name) continue;
    const auto found = places.find(family.judged_as);
    if (found == places.end() || found->second.size != family.problems.size()) {
      throw std::logic_error(family.name + " has no counterpart in " + family.judged_as);
    }
    for (std::size_t i = 0; i < family.problems.size(); ++i) {
      questions[found->second.first + i].forms.push_back(family.problems[i]);
    }
  }
  return questions;
}

}  // namespace ricochet::studies::best_values
