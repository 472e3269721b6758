#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "src/core/interruption.h"

namespace ricochet {

/// What was asked for is right, but its output gets nowhere: the disk is full, the device fails.
/// The message is one line with the file and the reason. The command line ends with exit code 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether the error number blames the system, as a full disk does, and not what the user named.
bool is_failure_of_the_system(int error);

/// A text on its way into a file. Until it is committed it stands aside in the same folder; a draft
/// that is not leaves no trace. A link is followed, a regular file keeps its mode and owner, and
/// one that is read-only is refused. Devices, pipes and names such as /dev/stdout are written
/// through.
class TextDraft {
 public:
  /// Writes the text aside, down to the disk. Throws InputError where the file can be none, and
  /// OutputError where the text does not get there.
  TextDraft(std::filesystem::path file, std::string_view text);
  ~TextDraft();
  TextDraft(const TextDraft&) = delete;
  TextDraft& operator=(const TextDraft&) = delete;

  /// Replaces the file by the draft, all or nothing. Throws as the constructor does.
  void commit();

 private:
  void discard() const;
  [[noreturn]] void fail(int error) const;
  void write_aside(std::string_view text);
  void write_through() const;

  std::filesystem::path file_;     ///< as the user knows it
  std::filesystem::path target_;   ///< where its links lead to
  std::optional<int> descriptor_;  ///< of a name such as /dev/stdout
  std::filesystem::path draft_;    ///< empty where it is written through, and once committed
  std::string text_;               ///< where it is written through
  AtInterruption interrupted_;
};

/// Replaces the file by `text`: a draft that is committed at once.
void write_text_file(const std::filesystem::path& file, std::string_view text);

}  // namespace ricochet
