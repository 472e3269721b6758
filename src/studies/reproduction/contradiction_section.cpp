#include <fmt/format.h>

#include "src/report/text.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

const CaseStudy& the(const Study& study, const char* id) {
  for (const CaseStudy& c : study.cases) {
    if (c.the_case.id == id) return c;
  }
  throw std::logic_error("a case is missing");
}

std::string threshold_of(const Study& study, const char* id) {
  return report::text_or_dash(the(study, id).score.threshold, "{:.2f}");
}

std::string forcing(const Reading& reading) {
  if (reading.forcing == Centrifugal::projected) {
    return "Projected onto x: it varies as the cosine of the angle turned. A force that always "
           "points one way gives no reading that comes near.";
  }
  return "Always one way, as printed.";
}

std::string window(const FittedReading& fitted) {
  const auto* turns = std::get_if<Revolutions>(&fitted.scene.window);
  if (turns != nullptr) {
    return fmt::format("An angle: {:.4g} turns of the driver plate.", turns->count);
  }
  return fmt::format("A time: {:.4g} s.", std::get<Seconds>(fitted.scene.window).count);
}

std::string constants(const FittedReading& fitted) {
  return fmt::format(
      "{} constants are fitted, the others held at what the paper or the scene "
      "suggests ({}). Hard walls need no stiffness, exact events no sampling.",
      fitted.freed.size(), fitted.provenance);
}

}  // namespace

report::Section contradiction_section(const Study& study) {
  const FittedReading& fitted = study.reading;
  report::Section section{"contradictions", "Where the paper contradicts itself, or is silent"};
  section.paragraphs = {
      "Each line is a decision that the published text leaves to the reader. What each answer "
      "costs, against all others, is the subject of a study of its own: ricochet calibrate "
      "--all-readings."};
  report::Table table{"What the paper leaves open, what is done here, and what speaks for it.",
                      {{"no.", report::Alignment::right},
                       {"the paper", report::Alignment::left},
                       {"here", report::Alignment::left}},
                      {}};
  const auto row = [&table](const char* paper, const std::string& here) {
    table.rows.push_back({{std::to_string(table.rows.size() + 1)}, {paper}, {here}});
  };
  row("The lower limit of a counted peak is 0.001 m in equation (33), 0.0001 m in the sentence "
      "below it.",
      "Neither: impacts count by their speed. The rule `peaks` takes either limit.");
  row("It counts local maxima, but a maximum near the inner wall is a small rebound, while a hit "
      "on that wall is a minimum.",
      "Impacts on either wall count, if faster than a limit.");
  row("C10 has more disturbance than C6 and a higher threshold, 2 against 1.9 rad/s, against "
      "conclusion (C).",
      fmt::format("Computed: C2 {}, C6 {}, C10 {} rad/s, as their disturbance grows.",
                  threshold_of(study, "C2"), threshold_of(study, "C6"),
                  threshold_of(study, "C10")));
  row("C5 is once given friction 0.4, and Figure 13 is captioned with restitution 0.9.",
      fmt::format("C5 has friction 0.1: with 0.4 its threshold is C7's, {} rad/s, and not near 8. "
                  "Figure 13 is C9, restitution 0.1: with 0.9 its quiet example, 3.6 rad/s, would "
                  "be loud, for C10's threshold is {} rad/s.",
                  threshold_of(study, "C7"), threshold_of(study, "C10")));
  row("Section 3.3.2 discusses friction 0.4 with the numbers of friction 0.1 (count 12, threshold "
      "2 rad/s).",
      fmt::format("They are C2's: computed there {} and {} rad/s; with friction 0.4, C4, {} and {} "
                  "rad/s.",
                  the(study, "C2").score.quiet_count, threshold_of(study, "C2"),
                  the(study, "C4").score.quiet_count, threshold_of(study, "C4")));
  row("The centrifugal force acts along the fixed x axis at every instant, though it turns with "
      "the carrier.",
      forcing(fitted.reading));
  row("The direction of the yarn tension: fixed, or turning with the driver plate.",
      fitted.reading.tension == Tension::constant ? "Fixed." : "Turning.");
  row("The length of the simulated window: a time, or an angle of rotation.", window(fitted));
  row("Tension, stiffness, walls, start, law and normal force of the friction, integrator and "
      "sampling are not given.",
      constants(fitted));
  row("The random disturbance is a cosine, the same in every run.", "A cosine.");
  row("Equation (24) prints the number of sparks between its limits as round(a m); the base mass "
      "m_c is ambiguous; equation (5) does not follow from (4) as printed.",
      "Both forms of (24) compete as solvers; only the total mass enters; (4) is read so that (5) "
      "follows.");
  section.tables = {std::move(table)};
  return section;
}

}  // namespace ricochet::studies::reproduction
