#include "src/cli/description.h"

#include <cstdio>

#include "src/cli/commands.h"
#include "src/cli/completion.h"
#include "src/cli/manual.h"
#include "src/cli/other_program.h"

namespace ricochet::cli {
namespace {

using report::Json;

/// Includes the commands of the other programs, if these can be called.
Json every_description(const CommandLine& line) {
  Json commands = line.description();
  for (const OtherCommand& other : {reproduction, other_commands[0]}) {
    const Json others = Json::parse(output_of(other, "describe"), nullptr, false);
    if (others.is_discarded()) continue;
    for (const Json& theirs : others) {
      for (Json& own : commands) {
        if (own["name"] == theirs["name"]) own = theirs;
      }
    }
  }
  return commands;
}

}  // namespace

void add_describe(CommandLine& line) {
  CLI::App* command = line.add("describe", "Prints the manual, or the completion of a shell");
  const auto form = std::make_shared<std::string>();
  command->group("");  // hidden
  command->add_option("form", *form, "What to print")
      ->required()
      ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
  line.on_call(command, [&line, form] {
    const Json commands = every_description(line);
    std::fputs((*form == "man" ? manual(commands) : completion(*form, commands)).c_str(), stdout);
    return 0;
  });
}

}  // namespace ricochet::cli
