#include "src/app/command_line.h"
#include "src/app/other_program.h"

int main(int argc, char** argv) {
  using namespace ricochet::cli;
  CommandLine line;
  line.start_group("machine");
  add_machine(line);
  add_simulate(line);
  add_threshold(line);
  add_regimes(line);
  add_identify(line);
  add_scene(line);
  line.start_group("solve");
  add_problem(line);
  add_list(line);
  add_solve(line);
  add_evaluate(line);
  add_ask(line);
  add_tell(line);
  add_compare(line);
  add_choose(line);
  line.start_group("campaign");
  add_plan(line);
  add_run(line);
  add_replay(line);
  add_merge(line);
  add_digest(line);
  add_submit(line);
  add_export(line);
  add_report(line);
  add_site(line);
  add_other(line, reproduction);
  for (const OtherCommand& other : other_commands) add_other(line, other);
  add_describe(line);
  return line.run(argc, argv);
}
