#pragma once

#include <filesystem>
#include <string>

/// Programs that the tests write: a few lines for the shell.
namespace ricochet::outside {

/// An empty folder of this test's own.
std::filesystem::path fresh_folder();

/// The command that runs these lines, from a file in the folder, which they know as $HERE.
std::string script(const std::filesystem::path& folder, const std::string& lines);

/// The text of a file.
std::string read(const std::filesystem::path& file);

}  // namespace ricochet::outside
