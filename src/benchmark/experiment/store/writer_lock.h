#pragma once

#include <filesystem>
#include <memory>

namespace ricochet {

/// Ensures that no other process writes to the file while this object lives: a lock on a file
/// beside it, with -lock after its name. A lock on the file itself would release SQLite's own when
/// it is given back.
class WriterLock {
 public:
  /// Throws InputError if another process has the lock, or no file can be made beside the file.
  explicit WriterLock(const std::filesystem::path& file);
  /// Null instead of an error.
  static std::unique_ptr<WriterLock> taken_if_free(const std::filesystem::path& file);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

  /// Returns true if a process has the lock.
  static bool is_taken(const std::filesystem::path& file);

 private:
  bool is_there() const;

  std::filesystem::path lock_;
  int descriptor_;
};

}  // namespace ricochet
