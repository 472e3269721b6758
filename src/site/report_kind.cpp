#include "src/site/report_kind.h"

namespace ricochet::site {

std::span<const ReportKind> report_kinds() {
  static constexpr ReportKind kinds[] = {
      {"reproduction", "The paper's cases", "How fast may the machines of the paper turn?",
       "./ricochet reproduce"},
      {"contest", "Solvers", "Which solver, when?", "./ricochet compare"},
      {"advice", "Your machine", "How fast may a machine of your own turn?",
       "./ricochet machine advise machine.toml"},
      {"dynamics", "The motion", "How much model, and which method, does the motion need?",
       "./ricochet dynamics"},
      {"surrogate", "The surrogate", "Can the smooth surrogate be trusted?",
       "./ricochet surrogate"},
      {"problems", "The problems", "What is asked of the solvers?", "./ricochet problems"},
      {"calibration", "The constants", "Which constants give the paper's thresholds?",
       "./ricochet calibrate --all-readings"},
      {"limits", "The limits", "How near can any reading come to the paper?", "./ricochet limits"},
      {"trials", "Untried readings", "Would a reading that nobody has tried come nearer?",
       "./ricochet trials"},
      {"verification", "The proof", "Is every impact found?", "./ricochet verify"},
      {"stress", "Ill problems", "What does a solver do where a problem is ill?",
       "./ricochet stress"},
      {"fireworks", "Fireworks", "Does the fireworks algorithm do what was published?",
       "./ricochet fireworks"},
  };
  return kinds;
}

}  // namespace ricochet::site
