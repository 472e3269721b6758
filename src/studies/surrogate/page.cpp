#include "src/studies/surrogate/page.h"

#include <fmt/format.h>

namespace ricochet::studies::surrogate {

report::Page page_of(const Study& study) {
  report::Page page;
  page.title = "Can the surrogate be trusted?";
  page.intro = {
      "The collision count is a whole number: it jumps, and between its jumps it is flat, so its "
      "derivative says nothing. The surrogate counts softly: an impact just slower than the "
      "slowest that counts already weighs something, one just faster not yet all. How softly is "
      "the smoothing width. The surrogate has exact derivatives, and solvers can follow them. But "
      "where to?",
      "This report asks what smoothing costs, whether coming from a wide width to a narrow one "
      "helps, where the gradient means something, whether the surrogate is as continuous as it "
      "should be, how its gradient grows with sensitivity and at grazing, and whether the exact "
      "derivatives of all problems are right. Every figure here is computed, with the default "
      "reading of the paper."};
  page.sections = {bias_section(study.gap),
                   continuation_section(study.guidance),
                   gradient_doubt_section(study.validity),
                   continuity_section(study.continuity),
                   growth_section(study.growth),
                   derivative_check_section(study.agreement)};
  report::Section origin{"origin", "What made this report"};
  origin.paragraphs = {fmt::format(
      "ricochet 0.1.0, ricochet surrogate; {:.0f} s. Every number but the times comes out the same "
      "again.",
      study.seconds)};
  page.sections.push_back(std::move(origin));
  return page;
}

}  // namespace ricochet::studies::surrogate
