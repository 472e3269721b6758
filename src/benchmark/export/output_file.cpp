#include "src/benchmark/export/output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "ricochet/error.h"
#include "src/core/interruption.h"
#include "src/core/text_file.h"

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

void write_file(const std::filesystem::path& file, std::string_view text) {
  OutputFile out(file);
  out.write(text);
  out.close();
}

}  // namespace ricochet::exports
