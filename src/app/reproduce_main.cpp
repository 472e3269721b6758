#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/studies/reproduction/study.h"

/// The reproduction of the paper. It is a separate program, so that the first report can be made
/// before the other commands are compiled.
int main(int argc, char** argv) {
  using namespace ricochet;
  cli::CommandLine line;
  CLI::App* command =
      line.add(cli::reproduction.command, cli::reproduction.summary,
               "  ricochet reproduce                      writes reports/reproduction/index.html\n"
               "  ricochet reproduce --quick --out first  a first look, in seconds");
  const auto options = cli::add_study_options(command, studies::reproduction_study({}, {}));
  line.on_call(command, [options] {
    const studies::Study study = studies::reproduction_study(options->out, cli::provenance());
    cli::tell(studies::run(study, options->quick, options->out));
    return 0;
  });
  line.add_description();
  return line.run(argc, argv);
}
