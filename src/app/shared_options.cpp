#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdint>

#include "src/app/command_line.h"

namespace ricochet::cli {

void print_table(const Table& table, bool json) {
  winsize size{};
  const bool is_terminal = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  fmt::print("{}", json ? json_rows_of(table).dump(2) + "\n"
                        : terminal_text_of(table, is_terminal ? size.ws_col : SIZE_MAX));
}

Table impact_table(std::span<const carrier_track::Impact> impacts) {
  Table table{"impacts", {{"time", "time [s]", ".8f"}, {"wall"}, {"speed", "speed [m/s]", ".6g"}}};
  for (const carrier_track::Impact& impact : impacts) {
    table.add(impact.time, name_of(impact.wall), impact.speed);
  }
  return table;
}

std::shared_ptr<StudyOptions> add_study_options(CLI::App* command, const studies::Study& study) {
  auto options = std::make_shared<StudyOptions>(StudyOptions{false, "reports/" + study.name});
  if (!study.quick.empty()) command->add_flag("--quick", options->quick, study.quick);
  add_value(command, "--out", options->out, "Folder for the report", "FOLDER");
  return options;
}

void add_format(CLI::App* command, bool& json) {
  command->add_option("--format", "What to print: text or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json"}))
      ->default_str("text")
      ->each([&json](const std::string& format) { json = format == "json"; });
}

void add_settings(CLI::App* command, std::vector<std::string>& settings) {
  add_value(command, "--set", settings,
            "Change a key of the scene, such as friction=0.3 or 'wall_upper=0.9 mm'; may be "
            "repeated",
            "KEY=VALUE")
      ->allow_extra_args(false);
}

void add_scene_file(CLI::App* command, std::string& file, std::vector<std::string>& settings) {
  add_value(command, "--scene", file,
            "A machine file (TOML): problems of this machine, whose names end in -scene", "FILE");
  add_settings(command, settings);
}

void add_limits(CLI::App* command, Limits& limits) {
  add_value(command, "--run-seconds", limits.seconds,
            "Longest time of a run [s]; then it is killed");
  add_value(command, "--run-megabytes", limits.megabytes, "Most memory of a run [MB]");
}

void add_allowance(CLI::App* command, bool& allowed) {
  command->add_flag("--allow-programs", allowed,
                    "Start the programs and shared libraries that the file names");
}

}  // namespace ricochet::cli
