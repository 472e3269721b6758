#include "src/analysis/export/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/progress.h"

namespace ricochet::exports {

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  const std::string message = fmt::format("{}: cannot be written: {}", file.string(),
                                          std::generic_category().message(error));
  if (is_failure_of_the_system(error)) throw OutputError(message);
  throw InputError(message);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)) {
  const Uninterrupted not_while_the_folder_is_removed;
  stream_ = std::fopen(file_.c_str(), "wxe");  // must be new; not inherited by other programs
  if (stream_ == nullptr) fail(file_, errno);
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stream_) != text.size()) fail(file_, errno);
}

void OutputFile::close() {
  if (std::fclose(std::exchange(stream_, nullptr)) != 0) fail(file_, errno);
}

TableFile::TableFile(const std::filesystem::path& file, std::vector<Column> columns, Writer writer)
    : batch_{file.stem().string(), std::move(columns)}, writer_(std::move(writer)), file_(file) {}

void TableFile::add_row(std::vector<Value> row) {
  constexpr std::size_t enough = 1000;
  batch_.add_row(std::move(row));
  if (batch_.rows.size() == enough) write();
}

void TableFile::write() {
  if (!std::exchange(begun_, true)) file_.write(writer_(batch_, Lines::head));
  file_.write(writer_(batch_, Lines::rows));
  batch_.rows.clear();
}

void TableFile::close(std::string_view foot) {
  write();
  file_.write(foot);
  file_.close();
}

void write_file(const std::filesystem::path& file, std::string_view text) {
  OutputFile out(file);
  out.write(text);
  out.close();
}

namespace {

namespace fs = std::filesystem;

fs::path usable(fs::path folder) {
  std::error_code error;
  if (fs::exists(folder, error)) {
    const bool empty = fs::is_directory(folder, error) && fs::is_empty(folder, error);
    if (!empty || error) {
      throw InputError(
          fmt::format("--out {}: must be a folder that is new or empty", folder.string()));
    }
  }
  return folder;
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder)
    : folder_(usable(std::move(folder))),
      made_(folder_),
      draft_(folder_ / fmt::format(".ricochet.{}.part", getpid())),
      interrupted_([this] { discard(); }) {
  std::error_code error;
  fs::create_directory(draft_, error);
  if (!error) return;
  throw OutputError(fmt::format("{}: cannot be made: {}", draft_.string(), error.message()));
}

OutputFolder::~OutputFolder() {
  discard();
}

void OutputFolder::discard() const {
  std::error_code ignored;
  if (!draft_.empty()) fs::remove_all(draft_, ignored);
}

void OutputFolder::commit() {
  const Uninterrupted whole;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(draft_)) entries.push_back(entry.path());
  std::error_code error;
  for (const fs::path& entry : entries) {
    fs::rename(entry, folder_ / entry.filename(), error);
    if (error) {
      throw OutputError(
          fmt::format("{}: cannot be moved to its place: {}", entry.string(), error.message()));
    }
  }
  fs::remove(draft_, error);
  draft_.clear();
}

}  // namespace ricochet::exports
