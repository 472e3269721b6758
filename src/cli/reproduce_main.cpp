#include "src/cli/command_line.h"
#include "src/cli/other_program.h"
#include "src/cli/provenance.h"
#include "src/cli/tell.h"
#include "src/research/reproduction/study.h"

namespace ricochet::cli {
namespace {

/// The reproduction of the paper. It is a separate program, so that the first report can be made
/// before the other commands are compiled.
class Reproduction : public CommandLine {
 public:
  Reproduction() {
    CLI::App* command =
        add(reproduction.command, reproduction.summary,
            "  ricochet reproduce                      writes reports/reproduction/index.html\n"
            "  ricochet reproduce --quick --out first  a first look, in seconds");
    StudyOptions& options = add_study_options(command, studies::reproduction_study({}, {}));
    on_call(command, [&options] {
      const studies::Study study = studies::reproduction_study(options.out, provenance());
      tell(studies::run(study, options.quick, options.out));
      return 0;
    });
    add_description();
  }
};

}  // namespace
}  // namespace ricochet::cli

int main(int argc, char** argv) {
  return ricochet::cli::Reproduction().run(argc, argv);
}
