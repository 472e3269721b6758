#include "src/cli/manual.h"

#include <fmt/format.h>

#include <sstream>
#include <vector>

#include "src/cli/description.h"
#include "src/cli/version.h"

namespace ricochet::cli {
namespace {

using report::Json;

/// Escapes text for man, so that no character of it is a command.
std::string plain(const std::string& text) {
  std::string escaped;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!escaped.empty()) escaped += '\n';
    if (line.starts_with('.') || line.starts_with('\'')) escaped += "\\&";
    for (const char sign : line) {
      escaped += sign == '\\' ? "\\e" : sign == '-' ? "\\-" : std::string(1, sign);
    }
  }
  return escaped;
}

std::string option(const Json& described) {
  const auto names = described.at("names").get<std::vector<std::string>>();
  const auto choices = described.at("choices").get<std::vector<std::string>>();
  const std::string value = text_of(described, "value"), standard = text_of(described, "default");
  std::string text = fmt::format(
      ".TP\n\\fB{}\\fR{}\n{}.",
      plain(names.empty() ? text_of(described, "name") : fmt::format("{}", fmt::join(names, ", "))),
      described.at("takes_value").get<bool>() && !names.empty()
          ? " \\fI" + plain(value.empty() ? "VALUE" : value) + "\\fR"
          : "",
      plain(text_of(described, "help")));
  if (!choices.empty()) text += "\n" + plain(fmt::format("One of {}.", fmt::join(choices, ", ")));
  if (!standard.empty()) text += "\n" + plain(fmt::format("By default {}.", standard));
  return text + "\n";
}

}  // namespace

std::string manual(const Json& commands) {
  const std::string full = version();
  std::string text = fmt::format(
      ".TH RICOCHET 1 \"\" \"{}\" \"User Commands\"\n"
      ".SH NAME\nricochet \\- the fastest quiet speed of a braiding machine, and solvers put to "
      "it\n"
      ".SH SYNOPSIS\n\\fBricochet\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n"
      ".SH COMMANDS\n",
      plain(full.substr(0, full.find(" (commit"))));
  for (const Json& command : commands) {
    text += fmt::format(".SS {}\n{}.\n", plain(text_of(command, "name")),
                        plain(text_of(command, "summary")));
    for (const Json& described : command.at("options")) text += option(described);
    const std::string examples = text_of(command, "examples");
    if (!examples.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", plain(examples));
  }
  text +=
      ".SH EXIT STATUS\n"
      ".TP\n0\nDone.\n"
      ".TP\n1\nA failure, as of a full disk; of verify: a count called certain is wrong; of "
      "evaluate: a "
      "line is no point.\n"
      ".TP\n2\nBad input.\n"
      ".TP\n130, 143\nInterrupted, by Ctrl\\-C and by SIGTERM.\n"
      ".SH ENVIRONMENT\n.TP\nNO_COLOR\nIf it is set, errors are not coloured on a "
      "terminal.\n.TP\nTERM\nIf it is \"dumb\" or not set, nothing is coloured or drawn again.\n";
  return text;
}

}  // namespace ricochet::cli
