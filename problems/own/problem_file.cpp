#include "problems/own/problem_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "ricochet/error.h"
#include "src/core/toml_fields.h"

namespace ricochet::own {

const EnumNames<Goal>& names_of(Goal /*value*/) {
  static const EnumNames<Goal> names = {{"minimise", Goal::minimise}, {"maximise", Goal::maximise}};
  return names;
}

const EnumNames<Scale>& names_of(Scale /*value*/) {
  static const EnumNames<Scale> names = {{"linear", Scale::linear},
                                         {"logarithmic", Scale::logarithmic}};
  return names;
}

const EnumNames<ConstraintKind>& names_of(ConstraintKind /*value*/) {
  static const EnumNames<ConstraintKind> names = {{"inequality", ConstraintKind::inequality},
                                                  {"equality", ConstraintKind::equality},
                                                  {"binary", ConstraintKind::binary}};
  return names;
}

const EnumNames<PointFormat>& names_of(PointFormat /*value*/) {
  static const EnumNames<PointFormat> names = {{"numbers", PointFormat::numbers},
                                               {"dakota", PointFormat::dakota}};
  return names;
}

constexpr Range finite_number{.least = std::numeric_limits<double>::lowest(),
                              .most = std::numeric_limits<double>::max(),
                              .brief = "finite",
                              .words = "a finite number"};

template <class Visit, IsOf<FileVariable>... V>
void visit_fields(const Visit& visit, V&... v) {
  using enum Presence;
  visit(Field{"name", "", "", {}, required}, Name{v.name}...);
  visit(Field{"unit"}, v.unit...);
  visit(Field{"lower", "1", "", finite_number, required}, v.lower...);
  visit(Field{"upper", "1", "", finite_number, required}, v.upper...);
  visit(Field{"start", "1", "", finite_number}, v.start...);
  visit(Field{"scale"}, v.scale...);
}

void check_fields(const TomlTable& in, const FileVariable& v) {
  if (v.upper < v.lower) in.refuse("upper", fmt::format("no less than lower, {}", v.lower));
  if (v.scale == Scale::logarithmic && v.lower <= 0) {
    in.refuse("lower", "> 0, as the scale is logarithmic");
  }
  if (v.start && (*v.start < v.lower || *v.start > v.upper)) {
    in.refuse("start", fmt::format("within {}..{}", v.lower, v.upper));
  }
}

template <class Visit, IsOf<FileConstraint>... C>
void visit_fields(const Visit& visit, C&... c) {
  visit(Field{"name", "", "", {}, Presence::required}, Name{c.name}...);
  visit(Field{"kind"}, c.kind...);
}

template <class Visit, IsOf<FileProgram>... P>
void visit_fields(const Visit& visit, P&... p) {
  visit(Field{"command"}, p.command...);
  visit(Field{"executable"}, p.executable...);
  visit(Field{"library"}, p.library...);
  visit(Field{"told"}, p.told...);
  visit(Field{"outputs"}, p.outputs...);
  visit(Field{"format"}, p.format...);
  visit(Field{"derivatives"}, p.derivatives...);
  visit(Field{"gradient_cost", "1", "", whole_number(0)}, p.gradient_cost...);
  visit(Field{"residuals", "1", "", whole_number(0)}, p.residuals...);
  visit(Field{"seconds", "s", "", positive_number}, p.seconds...);
  visit(Field{"megabytes", "1", "", positive_number}, p.megabytes...);
  visit(Field{"files"}, p.files...);
}

void check_fields(const TomlTable& in, const FileProgram& p) {
  const int ways = !p.command.empty() + !p.executable.empty() + !p.library.empty() + p.told;
  if (ways != 1) {
    throw InputError(in.place() + ": must have one of command, executable, library and told");
  }
  if (p.executable.empty() && p.format != PointFormat::numbers) {
    in.refuse("format", "left out but for an executable");
  }
  if (p.executable.empty() && !p.told && !p.outputs.empty()) {
    in.refuse("outputs", "left out but for an executable, and for values that are told");
  }
  if (!p.derivatives && p.gradient_cost) {
    in.refuse("gradient_cost", "left out where derivatives is false");
  }
  if (!p.executable.empty() && p.derivatives) {
    in.refuse("derivatives", "false for an executable; a command can give derivatives");
  }
}

template <class Visit, IsOf<ProblemFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  using enum Presence;
  visit(Field{"name", "", "", {}, required}, Name{f.name}...);
  visit(Field{"unit"}, f.unit...);
  visit(Field{"goal", "", "", {}, stated}, f.goal...);
  visit(Field{"noise"}, f.noise...);
  visit(Field{"jumps"}, f.jumps...);
  visit(Field{"best_known", "1", "", finite_number}, f.best_known...);
  visit(Field{"tolerance", "1", "", positive_number}, f.tolerance...);
  visit(Field{"program", "", "", {}, required}, f.program...);
  visit(Field{"variable", "", "", {}, required}, f.variables...);
  visit(Field{"constraint"}, f.constraints...);
}

namespace {

/// The names of what an executable prints, in the usual order.
std::vector<std::string> usual_outputs(const ProblemFile& file) {
  std::vector<std::string> names = {file.program.residuals > 0 ? "residuals" : "objective"};
  for (const FileConstraint& constraint : file.constraints) names.push_back(constraint.name);
  return names;
}

void check_outputs(const TomlTable& in, const ProblemFile& file) {
  std::vector<std::string> needed = usual_outputs(file);
  std::vector<std::string> known = needed;
  if (file.program.residuals > 0) known.emplace_back("objective");
  std::set<std::string> given;
  for (const std::string& name : file.program.outputs) {
    if (name == "ignored") continue;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      known.emplace_back("ignored");
      throw InputError(fmt::format("{}: program.outputs: {}: there is no such output; {}",
                                   in.place(), one_line(name), what_instead(name, known)));
    }
    if (!given.insert(name).second) {
      throw InputError(fmt::format("{}: program.outputs: {} twice", in.place(), name));
    }
  }
  for (const std::string& name : needed) {
    if (!file.program.outputs.empty() && !given.contains(name)) {
      throw InputError(fmt::format("{}: program.outputs: {} is missing", in.place(), name));
    }
  }
}

/// Throws InputError if two have the same name, or one has that of another output.
template <class List>
void check_distinct(const TomlTable& in, const char* what, const List& list) {
  std::set<std::string> names = {"objective", "residuals", "ignored"};
  for (const auto& each : list) {
    if (names.insert(each.name).second) continue;
    throw InputError(fmt::format("{}: {} {}: the name is taken", in.place(), what, each.name));
  }
}

}  // namespace

void check_fields(const TomlTable& in, const ProblemFile& file) {
  check_distinct(in, "variable", file.variables);
  check_distinct(in, "constraint", file.constraints);
  check_outputs(in, file);
  const bool room = std::any_of(file.variables.begin(), file.variables.end(),
                                [](const FileVariable& v) { return v.lower < v.upper; });
  if (!room) throw InputError(in.place() + ": at least one variable must have lower < upper");
  const auto equalities =
      std::count_if(file.constraints.begin(), file.constraints.end(),
                    [](const FileConstraint& c) { return c.kind == ConstraintKind::equality; });
  if (equalities > static_cast<std::ptrdiff_t>(file.variables.size())) {
    throw InputError(fmt::format("{}: {} equalities for {} variables: more than can be met",
                                 in.place(), equalities, file.variables.size()));
  }
}

namespace {

double to_scale(const FileVariable& variable, double x) {
  return variable.scale == Scale::logarithmic ? std::log(x) : x;
}

}  // namespace

std::vector<std::size_t> ProblemFile::order() const {
  std::vector<std::size_t> indices(constraints.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  std::stable_partition(indices.begin(), indices.end(), [this](std::size_t i) {
    return constraints[i].kind == ConstraintKind::equality;
  });
  return indices;
}

Vector ProblemFile::seen(const Vector& stated) const {
  Vector seen = stated;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    double& x = seen[static_cast<Eigen::Index>(i)];
    x = to_scale(variables[i], x);
  }
  return seen;
}

Vector ProblemFile::stated(const Vector& seen) const {
  Vector stated = seen;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const FileVariable& v = variables[i];
    double& x = stated[static_cast<Eigen::Index>(i)];
    if (v.scale == Scale::linear) continue;
    const double y = x;
    x = std::clamp(std::exp(y), v.lower, v.upper);
    if (y == std::log(v.lower)) x = v.lower;
    if (y == std::log(v.upper)) x = v.upper;
    if (v.start && y == std::log(*v.start)) x = *v.start;
  }
  return stated;
}

bool is_problem_file(const std::string& text) {
  return text.ends_with(".toml");
}

ProblemFile problem_file_from(const std::string& text, const std::filesystem::path& path) {
  ProblemFile file = fields_from<ProblemFile>(text, path.string());
  if (file.program.outputs.empty() && (file.program.told || !file.program.executable.empty())) {
    file.program.outputs = usual_outputs(file);
  }
  for (FileVariable& v : file.variables) {
    if (v.start) continue;
    v.start = v.scale == Scale::logarithmic
                  ? std::clamp(std::sqrt(v.lower) * std::sqrt(v.upper), v.lower, v.upper)
                  : v.lower + (v.upper - v.lower) / 2;
  }
  file.path = path;
  return file;
}

ProblemFile read_problem_file(const std::filesystem::path& path) {
  return problem_file_from(read_toml_text(path.string()), path);
}

std::string text_of(const ProblemFile& file) {
  return toml_of_fields(file);
}

}  // namespace ricochet::own
