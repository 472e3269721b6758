#include "solvers/outside/content.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace ricochet::outside {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

/// Where execvp() finds the program; empty if it does not.
fs::path found_on_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return program;
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "/bin:/usr/bin");
  for (std::string folder; std::getline(list, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / program;
    if (is_file(file) && ::access(file.c_str(), X_OK) == 0) return file;
  }
  return {};
}

/// Everything that changes if a file is written or replaced.
bool same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
         a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec &&
         a.st_ctim.tv_sec == b.st_ctim.tv_sec && a.st_ctim.tv_nsec == b.st_ctim.tv_nsec;
}

}  // namespace

Content::File Content::read(const fs::path& path) {
  File file{path, {}, 0};
  ::stat(path.c_str(), &file.status);
  FnvHash hash;
  std::ifstream in(path, std::ios::binary);
  std::string chunk(1 << 16, '\0');
  while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
    hash.add(std::string_view(chunk).substr(0, static_cast<std::size_t>(in.gcount())));
  }
  file.hash = hash.value();
  return file;
}

void Content::add_text(std::string_view text) {
  hash_.add(fmt::format("text of {} bytes: {}", text.size(), text));
}

void Content::add_file(const fs::path& file) {
  files_.push_back(read(file));
  hash_.add(fmt::format("file {:016x}", files_.back().hash));
}

std::string Content::hash() const {
  return fmt::format("{:016x}", hash_.value());
}

std::string Content::changed() const {
  for (const File& file : files_) {
    struct stat now {};
    const bool there = ::stat(file.path.c_str(), &now) == 0;
    if (there && same(now, file.status)) continue;
    if (!there || read(file.path).hash != file.hash) return file.path.string();
  }
  return "";
}

Content content_of_command(const std::vector<std::string>& words) {
  Content content;
  const fs::path program = found_on_path(words.front());
  if (is_file(program) && !is_of_the_system(program)) {
    content.add_file(program);
  } else {
    content.add_text(fs::path(words.front()).filename().string());
  }
  for (std::size_t k = 1; k < words.size(); ++k) {
    const std::string& word = words[k];
    const std::size_t value = word.find('=') + 1;  // 0: there is no =
    if (is_file(word)) {
      content.add_file(word);
    } else if (value > 0 && is_file(word.substr(value))) {
      content.add_text(word.substr(0, value));
      content.add_file(word.substr(value));
    } else {
      content.add_text(word);
    }
  }
  return content;
}

bool is_of_the_system(const fs::path& file) {
  std::error_code none;
  const std::string place = fs::canonical(file, none).string();
  for (const char* folder : {"/usr/", "/bin/", "/sbin/", "/lib/", "/lib64/"}) {
    if (place.starts_with(folder)) return !place.starts_with("/usr/local/");
  }
  return false;
}

}  // namespace ricochet::outside
