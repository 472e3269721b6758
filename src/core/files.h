#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "src/core/progress.h"

namespace ricochet {

/// Correct input whose output cannot be written: the disk is full, the device fails. The message is
/// one line with the file and the reason. The command line ends with exit code 1.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Returns true if the error number is a fault of the system, such as a full disk, and not of the
/// path that the user gave.
bool is_failure_of_the_system(int error);

/// Whether a file is written through a symbolic link, or into a device or pipe: where the user gave
/// its name, but not where it is one of a folder's, which may be a stranger's.
enum class SymbolicLinks { followed, refused };

/// A folder that is or will be in another, which may be a stranger's. Throws InputError if there is
/// something else of that name, such as a link to another folder.
std::filesystem::path below(const std::filesystem::path& folder, const std::string& name);

/// The content of a file of a folder that may be a stranger's. Throws InputError if it cannot be
/// read, or is a folder, device or pipe, on which reading would wait.
std::string text_of_file(const std::filesystem::path& file);

/// A text to be written to a file. Until commit() it is in a temporary file in the same folder;
/// without commit() no trace is left. Symbolic links are followed unless they are refused; a
/// regular file keeps its mode and owner, and a read-only one is refused. Devices, pipes and names
/// such as /dev/stdout are written directly.
class TextDraft {
 public:
  /// Writes the temporary file, down to the disk. Throws InputError if the path cannot be a file,
  /// and OutputError if writing fails.
  TextDraft(std::filesystem::path file, std::string_view text,
            SymbolicLinks links = SymbolicLinks::followed);
  ~TextDraft();
  TextDraft(const TextDraft&) = delete;
  TextDraft& operator=(const TextDraft&) = delete;

  /// Replaces the file by the draft atomically. Throws as the constructor does.
  void commit();

 private:
  void discard() const;
  [[noreturn]] void fail(int error) const;
  void write_over(std::string_view text);
  void write_aside(std::string_view text);
  void write_through() const;

  std::filesystem::path file_;     ///< as the user gave it
  std::filesystem::path target_;   ///< after following links
  std::optional<int> descriptor_;  ///< of a name such as /dev/stdout
  std::filesystem::path draft_;    ///< empty if written directly, and after commit()
  std::string text_;               ///< only if written directly
  AtInterruption interrupted_;
};

/// Replaces the file by `text`: a draft that is committed at once.
void write_text_file(const std::filesystem::path& file, std::string_view text,
                     SymbolicLinks links = SymbolicLinks::followed);

/// Makes a folder and its missing parents; at the end it removes those that are still empty.
class MadeFolder {
 public:
  /// If the folder cannot be made or written to, leaves no trace and throws InputError (one line
  /// with path and reason), or OutputError if the disk is full.
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

 private:
  void take_back() const;

  std::vector<std::filesystem::path> made_;  ///< innermost first
  AtInterruption interrupted_;
};

/// A new folder below that for temporary files (the environment's TMPDIR, else /tmp), removed with
/// all that is in it at the end and at an interruption.
class ScratchFolder {
 public:
  /// Throws OutputError if it cannot be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  void remove() const;

  std::filesystem::path path_;
  AtInterruption interrupted_;
};

/// A folder, made if missing, that no other process can lock while this object lives.
class FolderLock {
 public:
  /// Throws as MadeFolder does, and InputError if another process has locked the folder.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  MadeFolder made_;
  int descriptor_;
};

}  // namespace ricochet
