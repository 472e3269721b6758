#include "src/app/command_line.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <numbers>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/report/json.h"

/// What a command line was probably meant to say, for its error. Each is empty if nobody can tell.
namespace ricochet::cli {

/// For an argument that the command does not expect, such as a case without its option:
/// "C1: give it as --case C1".
std::string hint_at_argument(const CLI::App& command, const std::string& argument);

/// For the first option with a value that is none of its choices, or is a number with a unit:
/// "--omega 60rpm: must be a number, without a unit, in rad/s: 6.28319".
std::string hint_at_value(const CLI::App& command);

/// For arguments that are missing: how the command is called.
std::string hint_at_call(const CLI::App& command, const std::string& path);

/// The values in the braces of an option's type.
std::vector<std::string> choices_of(const CLI::Option& option);

namespace {

using report::Json;

constexpr int failure = 1;
constexpr int bad_input = 2;

constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 a failure, as of a full disk, or a result that is not complete; 2 bad\n"
    "input; 130 and 143 interrupted, by Ctrl-C and by SIGTERM.";

/// A file that is opened must never take the descriptor of a standard stream that was closed. The
/// replacement rejects all input and output, so that lost output is noticed; messages on standard
/// error are lost, and the command does its work.
void fill_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    if (open("/dev/null", stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY) < 0) return;
  }
}

constexpr rlim_t usual_stack = 8 << 20;      // bytes
constexpr rlim_t necessary_stack = 1 << 20;  // bytes: libraries of solvers need a tenth of it

/// Raises a stack that is too small, as far as the system allows; that of threads to come, too.
void raise_stack() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= usual_stack) return;
  stack.rlim_cur = usual_stack;
  if (stack.rlim_max < usual_stack) stack.rlim_max = usual_stack;  // allowed to root only
  if (setrlimit(RLIMIT_STACK, &stack) != 0 && getrlimit(RLIMIT_STACK, &stack) == 0) {
    stack.rlim_cur = stack.rlim_max;
    setrlimit(RLIMIT_STACK, &stack);
  }
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, usual_stack);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

void require_stack() {
  rlimit stack{};
  if (getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= necessary_stack) return;
  throw InputError(fmt::format("the stack is limited to {} kB: must be at least {}, see ulimit -s",
                               stack.rlim_cur >> 10U, necessary_stack >> 10U));
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

Json description_of(const CLI::Option& option) {
  Json names = Json::array();
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  const std::string type = option.get_type_name();
  return {{"names", names},
          {"name", option.get_single_name()},
          {"takes_value", option.get_items_expected_max() > 0},
          {"value", type.substr(0, type.find(':'))},
          {"choices", choices_of(option)},
          {"help", option.get_description()},
          {"default", option.get_default_str()}};
}

/// The subcommands of a command, as the value that follows it.
Json description_of(const std::vector<const CLI::App*>& parts) {
  std::string help;
  for (const CLI::App* part : parts) {
    help += fmt::format("{}{}: {}", help.empty() ? "" : "; ", part->get_name(),
                        part->get_description());
  }
  return {{"names", Json::array()},     {"name", "COMMAND"}, {"takes_value", true}, {"value", ""},
          {"choices", names_of(parts)}, {"help", help},      {"default", ""}};
}

void append_options(const CLI::App& command, Json& options) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // hidden
    const Json described = description_of(*option);
    if (std::find(options.begin(), options.end(), described) == options.end()) {
      options.push_back(described);
    }
  }
}

/// Returns the arguments after the program's name; "help COMMAND" is read as "COMMAND --help".
std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (!arguments.empty() && arguments.front() == "help") {
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  }
  return arguments;
}

/// An empty value is usually a shell variable that was never set.
void refuse_empty_values(const CLI::App& called) {
  for (const CLI::Option* option : called.get_options()) {
    for (const std::string& value : option->results()) {
      if (value.empty()) throw InputError(option->get_name() + ": must not be empty");
    }
  }
  for (const CLI::App* command : called.get_subcommands()) refuse_empty_values(*command);
}

}  // namespace

CommandLine::CommandLine()
    : app_(
          "ricochet: the fastest quiet speed of a braiding machine, and a benchmark of solvers on "
          "it",
          "ricochet") {
  raise_stack();
  app_.require_subcommand(1);
  app_.set_version_flag("--version", version);
  app_.footer(fmt::format("{}\nricochet help COMMAND shows what a command takes, with examples.",
                          exit_codes));
}

CLI::App* CommandLine::add(const std::string& command, const std::string& summary,
                           const std::string& examples) {
  CLI::App* added = app_.add_subcommand(command, summary)->group(group_);
  add_usual_options(added);
  added->footer((examples.empty() ? "" : "Examples:\n" + examples + "\n") + exit_codes);
  return added;
}

CLI::App* CommandLine::add_part(CLI::App* command, const std::string& part,
                                const std::string& summary) {
  CLI::App* added = command->add_subcommand(part, summary)->group("Commands");
  add_usual_options(added);
  return added;
}

void CommandLine::add_usual_options(CLI::App* command) {
  command->add_flag_callback("--quiet", Progress::silence, "No progress on standard error");
  add_value(command, "--color", color_,
            "Errors in colour: auto means on a terminal that is not dumb, if NO_COLOR is not set",
            "WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

void CommandLine::on_call(CLI::App* command, const std::function<int()>& work) {
  command->callback([this, work] { work_ = work; });
}

int CommandLine::run(int argc, char** argv) {
  fill_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error, not the end
  return finish_output(carry_out(arguments_of(argc, argv)));
}

int CommandLine::carry_out(std::vector<std::string> arguments) {
  try {
    require_stack();
    if (!arguments.empty()) first_ = arguments.front();
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 reads a vector
    app_.parse(arguments);
    refuse_empty_values(app_);
    end_tidily_when_interrupted();
    return work_();
  } catch (const CLI::ParseError& error) {
    const bool informs = error.get_exit_code() == 0;  // --help, --version
    if (informs && !names_no_command()) return app_.exit(error);
    return fail(bad_input, fmt::format("{}; see {} --help", explanation(error), called().second));
  } catch (const InputError& error) {
    return fail(bad_input, error.what());
  } catch (const OutputError& error) {
    return fail(failure, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(is_failure_of_the_system(error.code().value()) ? failure : bad_input,
                error.path1().string() + ": " + error.code().message());
  } catch (const std::bad_alloc&) {
    return fail(failure, "failed: there is not enough memory");
  } catch (const std::system_error& error) {  // fmt::print throws one if it cannot print
    if (std::ferror(stdout) != 0)
      return fail(failure, "standard output: " + error.code().message());
    return fail(failure, fmt::format("failed: {}", error.what()));
  } catch (const std::exception& error) {
    return fail(failure, fmt::format("failed: {}", error.what()));
  }
}

int CommandLine::fail(int exit_code, const std::string& reason) const {
  const char* no_color = std::getenv("NO_COLOR");
  const bool allowed = no_color == nullptr || *no_color == '\0';
  const bool colored = color_ == "always" || (color_ == "auto" && allowed && Progress::redraws());
  std::fprintf(stderr, "%s %s\n",
               colored ? "\033[31mricochet:\033[m" : "ricochet:", one_line(reason).c_str());
  return exit_code;
}

int CommandLine::finish_output(int exit_code) const {
  const bool lost = std::ferror(stdout) != 0;
  errno = 0;
  if (std::fflush(stdout) == 0 && !lost && close(STDOUT_FILENO) == 0) return exit_code;
  if (exit_code != 0) return exit_code;
  const std::string reason =
      errno == 0 ? "not all could be written" : std::generic_category().message(errno);
  return fail(failure, "standard output: " + reason);
}

/// Returns true if the first word, in the place of the command, is none.
bool CommandLine::names_no_command() const {
  const auto commands = app_.get_subcommands(nullptr);
  return !first_.empty() && !first_.starts_with('-') &&
         std::ranges::find(commands, first_, &CLI::App::get_name) == commands.end();
}

/// Returns the command that is called, the program itself if it is none, and how to call it.
std::pair<const CLI::App*, std::string> CommandLine::called() const {
  const CLI::App* app = &app_;
  std::string path = app_.get_name();
  while (!names_no_command() && !app->get_subcommands().empty()) {
    app = app->get_subcommands().front();
    path += " " + app->get_name();
  }
  return {app, path};
}

/// Returns CLI11's message; for an unknown command or option it adds a suggestion.
std::string CommandLine::explanation(const CLI::ParseError& error) const {
  if (names_no_command()) {
    if (first_ == "dynamics" || first_ == "impact-test")
      return fmt::format("{} is now `simulators`, which has both", first_);
    return fmt::format("{} is no command; {}", first_,
                       what_instead(first_, names_of(app_.get_subcommands(nullptr))));
  }
  const auto [app, path] = called();
  const std::string place = app == &app_ ? "" : app->get_name() + ": ";
  const std::vector<std::string> extra = app_.remaining(true);
  if (extra.empty()) {
    const bool lacks = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError);
    const std::string hint = lacks ? hint_at_call(*app, path) : hint_at_value(*app);
    if (!lacks && !hint.empty()) return place + hint;
    return place + error.what() + (hint.empty() ? "" : ", " + hint);
  }
  if (!extra.front().starts_with('-')) {
    const std::string hint = hint_at_argument(*app, extra.front());
    if (!hint.empty()) return place + hint;
  }
  std::vector<std::string> known = names_of(app->get_subcommands(nullptr));
  if (!known.empty() && !extra.front().starts_with('-')) {
    return fmt::format("{} is no command; {}", extra.front(), what_instead(extra.front(), known));
  }
  known.clear();
  for (const CLI::Option* option : app->get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  return fmt::format("{}{} is not expected; {}", place, extra.front(),
                     what_instead(extra.front().substr(0, extra.front().find('=')), known));
}

void CommandLine::add_description() {
  CLI::App* command = add("describe", "Prints a description of all commands as JSON");
  command->group("");  // hidden
  on_call(command, [this] {
    fmt::print("{}\n", description().dump());
    return 0;
  });
}

Json CommandLine::description() const {
  Json commands = Json::array();
  for (const CLI::App* command : app_.get_subcommands(nullptr)) {
    if (command->get_group().empty()) continue;
    Json options = Json::array();
    const std::vector<const CLI::App*> parts = command->get_subcommands(nullptr);
    if (!parts.empty()) options.push_back(description_of(parts));
    append_options(*command, options);
    Json described_parts = Json::array();
    for (const CLI::App* part : parts) {
      append_options(*part, options);
      Json own = Json::array();
      append_options(*part, own);
      described_parts.push_back({{"name", part->get_name()}, {"options", own}});
    }
    const std::string footer = command->get_footer();
    commands.push_back({{"name", command->get_name()},
                        {"summary", command->get_description()},
                        {"examples", footer.substr(0, footer.find(exit_codes))},
                        {"options", options},
                        {"parts", described_parts}});
  }
  return commands;
}

namespace {

bool is_number(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.starts_with("FLOAT") || type.starts_with("INT") || type.starts_with("UINT");
}

/// What follows the number at the beginning of a text; the whole text if there is none.
std::string_view after_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  std::string_view rest(end);
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  return rest;
}

std::string hint_at_number(const CLI::Option& option, const std::string& value) {
  const std::string_view unit = after_number(value);
  if (unit.empty()) return "";
  std::string hint = fmt::format("{} {}: must be a number", option.get_name(), value);
  if (unit.size() == value.size()) return hint;
  hint += ", without a unit";
  const bool in_radians = option.get_description().find("rad/s") != std::string::npos;
  if (!in_radians) return hint;
  hint += ", in rad/s";
  constexpr double of_a_minute = 2 * std::numbers::pi / 60;
  if (unit == "rpm" || unit == "1/min") {
    hint += fmt::format(": {:.6g}", std::strtod(value.c_str(), nullptr) * of_a_minute);
  }
  return hint;
}

}  // namespace

std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t start = type.find('{');
  if (start == std::string::npos) return {};
  return CLI::detail::split(type.substr(start + 1, type.find('}') - start - 1), ',');
}

std::string hint_at_argument(const CLI::App& command, const std::string& argument) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->get_lnames().empty()) continue;
    const std::vector<std::string> choices = choices_of(*option);
    const auto choice = std::ranges::find_if(
        choices, [&](const std::string& each) { return equal_in_any_case(each, argument); });
    if (choice != choices.end()) {
      return fmt::format("{0}: give it as {1} {2}", argument, option->get_name(), *choice);
    }
  }
  std::error_code none;
  const bool is_machine = std::filesystem::path(argument).extension() == ".toml" ||
                          std::filesystem::exists(argument, none);
  if (is_machine && command.get_option_no_throw("--scene") != nullptr) {
    return fmt::format("{0}: give it as --scene {0}", argument);
  }
  return "";
}

std::string hint_at_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> choices = choices_of(*option);
    const std::string type = option->get_type_name();
    const bool is_closed = !choices.empty() && type.find(":FILE") == std::string::npos &&
                           !type.starts_with("PLAN") && !type.starts_with("SOLVER");
    for (const std::string& value : option->results()) {
      if (is_closed && std::ranges::find(choices, value) == choices.end()) {
        const std::string name = option->get_positional() ? "" : option->get_name() + " ";
        return fmt::format("{}{}: {}", name, value, what_instead(value, choices));
      }
      std::string hint = is_number(*option) ? hint_at_number(*option, value) : "";
      if (!hint.empty()) return hint;
    }
  }
  return "";
}

std::string hint_at_call(const CLI::App& command, const std::string& path) {
  const std::string examples = command.get_footer();
  std::size_t start = examples.find("  " + path + " ");
  if (start == std::string::npos) return "";
  start += 2;
  return "as in: " + examples.substr(start, examples.find('\n', start) - start);
}

int cores() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace ricochet::cli
