#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>
#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/report/json.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {

/// Returns the text under a key in a description of the commands (CommandLine::description).
inline std::string text_of(const report::Json& object, const char* key) {
  return object.at(key).get<std::string>();
}

/// Returns the manual page of the commands of the description, as roff.
std::string manual(const report::Json& commands);

/// A script for "bash", "zsh" or "fish" that completes the commands of the description, their
/// options, and the names of problems, families, solvers, plans and cases.
std::string completion(const std::string& shell, const report::Json& commands);

namespace {

using boost::algorithm::replace_all_copy;
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

namespace {

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

namespace {

std::string words_of(const Json& list) {
  return fmt::format("{}", fmt::join(list.get<std::vector<std::string>>(), " "));
}

/// Returns true if the value may be a file, be it besides a name.
bool is_file(const Json& option) {
  const std::string value = text_of(option, "value");
  return value == "FILE" || value == "FOLDER" || value == "PLAN" || value == "SOLVER";
}

/// Adds the names of problems, families and solvers, too many for the help, to the options whose
/// values they are.
Json with_names(Json commands) {
  Json problems = Json::array(), families = Json::array(), solvers = Json::array();
  for (const Family& family : suite_families("")) {
    families.push_back(family.name);
    for (const Problem& problem : family.problems) problems.push_back(problem.name);
  }
  for (const Solver& solver : all_solvers()) solvers.push_back(solver.name);
  const auto name_values = [&](Json& options) {
    for (Json& option : options) {
      const std::string value = text_of(option, "value");
      if (value.starts_with("PROBLEM")) option["choices"] = problems;
      if (value.starts_with("SOLVER")) option["choices"] = solvers;
      if (value == "FAMILY") option["choices"] = families;
    }
  };
  for (Json& command : commands) {
    name_values(command.at("options"));
    for (Json& part : command.at("parts")) name_values(part.at("options"));
  }
  return commands;
}

bool is_positional(const Json& option) {
  return option.at("names").empty();
}

struct Offer {
  std::string words;
  bool files = false;
};

/// The options and the values of arguments.
Offer offer_of(const Json& options) {
  Offer offer;
  for (const Json& option : options) {
    offer.words += " " + words_of(option.at(is_positional(option) ? "choices" : "names"));
    offer.files = offer.files || (is_positional(option) && is_file(option));
  }
  return offer;
}

std::string bash_case(const std::string& pattern, const Offer& offer) {
  return fmt::format("    {}) words={}{} ;;\n", pattern, shell_quoted(offer.words),
                     offer.files ? " files=yes" : "");
}

/// The words that can follow a command's name and, if given, an option that takes a value.
std::string bash_case(const std::string& pattern, const Json& option) {
  return fmt::format("    {}) words={}{} ;;\n", pattern,
                     shell_quoted(words_of(option.at("choices"))),
                     is_file(option) ? " files=yes" : "");
}

std::string bash(const Json& commands) {
  std::string names = "--help --version help", cases;
  for (const Json& command : commands) {
    const std::string name = text_of(command, "name");
    names += " " + name;
    for (const Json& option : command.at("options")) {
      if (is_positional(option) || !option.at("takes_value").get<bool>()) continue;
      for (const Json& each : option.at("names")) {
        cases += bash_case(shell_quoted(name + " " + each.get<std::string>()), option);
      }
    }
    for (const Json& part : command.at("parts")) {
      cases +=
          bash_case(shell_quoted(name + " " + text_of(part, "name")), offer_of(part.at("options")));
    }
    cases += bash_case(shell_quoted(name + " ") + "*", offer_of(command.at("options")));
  }
  cases += fmt::format("    'help '*) words={} ;;\n", shell_quoted(names));
  return fmt::format(R"(# bash completion of ricochet
_ricochet() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words='' files=no
  if ((COMP_CWORD == 1)); then
    words={}
  else
    case "${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{}    esac
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; [[ $files == no ]] || compgen -f -- "$word")
  [[ $files == no ]] || compopt -o filenames 2>/dev/null
}}
complete -F _ricochet ricochet
)",
                     shell_quoted(names), cases);
}

/// Possible values of an option, in the syntax of zsh's _arguments.
std::string zsh_value(const Json& option) {
  const std::string words = words_of(option.at("choices"));
  if (is_file(option)) return words.empty() ? ":file:_files" : ":value:_ricochet_or_file " + words;
  return words.empty() ? ":value: " : fmt::format(":value:({})", words);
}

std::string zsh(const Json& commands) {
  std::string names, cases;
  for (const Json& command : commands) {
    const std::string name = text_of(command, "name");
    names += "    " + shell_quoted(name + ":" + text_of(command, "summary")) + "\n";
    std::string arguments;
    for (const Json& option : command.at("options")) {
      const std::string help =
          replace_all_copy(replace_all_copy(text_of(option, "help"), "[", "\\["), "]", "\\]");
      const bool takes_value = option.at("takes_value").get<bool>();
      if (is_positional(option))
        arguments += " \\\n        " + shell_quoted(":" + zsh_value(option));
      for (const Json& each : option.at("names")) {
        arguments += " \\\n        " + shell_quoted(each.get<std::string>() + "[" + help + "]" +
                                                    (takes_value ? zsh_value(option) : ""));
      }
    }
    if (!command.at("parts").empty()) arguments += " \\\n        '*:file:_files'";
    cases += fmt::format("    {})\n      _arguments{} ;;\n", name, arguments);
  }
  names += "    'help:Show what a command takes'\n";
  cases += "    help)\n      _describe command commands ;;\n";
  return fmt::format(R"(#compdef ricochet
_ricochet_or_file() {{
  compadd "$@"
  _files
}}
_ricochet() {{
  local -a commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT -= 1))
  case $command in
{}  esac
}}
_ricochet "$@"
)",
                     names, cases);
}

std::string fish_quoted(const std::string& text) {
  return "'" + replace_all_copy(replace_all_copy(text, "\\", "\\\\"), "'", "\\'") + "'";
}

/// Possible values of an option, in the syntax of fish.
std::string fish_value(const Json& option) {
  const std::string words = words_of(option.at("choices"));
  return (is_file(option) ? " -r -F" : " -x") + (words.empty() ? "" : " -a " + fish_quoted(words));
}

std::string fish(const Json& commands) {
  std::string text = "# fish completion of ricochet\ncomplete -c ricochet -f\n";
  std::string names;
  for (const Json& command : commands) {
    const std::string name = text_of(command, "name");
    text += fmt::format("complete -c ricochet -n __fish_use_subcommand -a {} -d {}\n", name,
                        fish_quoted(text_of(command, "summary")));
    const std::string start =
        fmt::format("complete -c ricochet -n '__fish_seen_subcommand_from {}'", name);
    names += " " + name;
    for (const Json& part : command.at("parts")) {
      if (!offer_of(part.at("options")).files) continue;
      text += fmt::format(
          "complete -c ricochet -n '__fish_seen_subcommand_from {}; and "
          "__fish_seen_subcommand_from "
          "{}' -F\n",
          name, text_of(part, "name"));
    }
    for (const Json& option : command.at("options")) {
      if (is_positional(option)) {
        const std::string words = words_of(option.at("choices"));
        text += start + (is_file(option) ? " -F" : "") +
                (words.empty() ? "" : " -a " + fish_quoted(words)) + "\n";
        continue;
      }
      for (const Json& each : option.at("names")) {
        const std::string of_option = each.get<std::string>();
        text += fmt::format("{} {} {}{} -d {}\n", start, of_option.starts_with("--") ? "-l" : "-s",
                            of_option.substr(of_option.find_first_not_of('-')),
                            option.at("takes_value").get<bool>() ? fish_value(option) : "",
                            fish_quoted(text_of(option, "help")));
      }
    }
  }
  text += fmt::format("complete -c ricochet -n '__fish_seen_subcommand_from help' -a {}\n",
                      fish_quoted(names));
  return text;
}

}  // namespace

std::string completion(const std::string& shell, const Json& commands) {
  const Json named = with_names(commands);
  return shell == "bash" ? bash(named) : shell == "zsh" ? zsh(named) : fish(named);
}

}  // namespace ricochet::cli
