#include "src/reproduction/sections.h"

namespace ricochet::reproduction {

report::Section contradiction_section() {
  report::Section section{"contradictions", "Where the paper contradicts itself, or is silent"};
  section.paragraphs = {
      "Each line is a decision that the published text leaves to the reader. The decisions here "
      "make "
      "up the starting reading."};
  report::Table table{"What the paper leaves open, and what is done here.",
                      {{"no.", report::Alignment::right},
                       {"the paper", report::Alignment::left},
                       {"here", report::Alignment::left}},
                      {}};
  const auto row = [&table](const char* paper, const char* here) {
    table.rows.push_back({{std::to_string(table.rows.size() + 1)}, {paper}, {here}});
  };
  row("The lower limit of a counted peak is 0.001 m in equation (33), 0.0001 m in the sentence "
      "below it.",
      "Neither: impacts count by their speed. The rule `peaks` takes either limit.");
  row("It counts local maxima, but a maximum near the inner wall is a small rebound, while a hit "
      "on "
      "that wall is a minimum.",
      "Impacts on either wall count, if faster than a limit.");
  row("C10 has more disturbance than C6 and a higher threshold, 2 against 1.9 rad/s, against "
      "conclusion (C).",
      "Computed as stated; the table of thresholds shows both.");
  row("C5 is once given friction 0.4, and Figure 13 is captioned with restitution 0.9.",
      "C5 has friction 0.1; Figure 13 is taken as C9, restitution 0.1.");
  row("Section 3.3.2 discusses friction 0.4 with the numbers of friction 0.1 (count 12, threshold "
      "2 rad/s).",
      "C2 keeps these numbers, C4 its own.");
  row("The centrifugal force acts along the fixed x axis at every instant, though it turns with "
      "the "
      "carrier.",
      "Projected onto x: it varies as the cosine of the angle turned.");
  row("The direction of the yarn tension: fixed, or turning with the driver plate.", "Fixed.");
  row("The length of the simulated window: a time, or an angle of rotation.",
      "An angle: 1.314 turns of the driver plate.");
  row("Tension, stiffness, walls, start, law and normal force of the friction, integrator and "
      "sampling are not given.",
      "Fitted constants of an exploratory study; hard walls need no stiffness, and exact events no "
      "sampling.");
  row("The random disturbance is a cosine, the same in every run.", "A cosine.");
  row("Equation (24) prints the number of sparks between its limits as round(a m); the base mass "
      "m_c is ambiguous; equation (5) does not follow from (4) as printed.",
      "Both forms of (24) compete as solvers; only the total mass of 1.2 kg enters; (4) is read so "
      "that (5) follows.");
  section.tables = {std::move(table)};
  return section;
}

}  // namespace ricochet::reproduction
