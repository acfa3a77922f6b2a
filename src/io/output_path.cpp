#include "wirepack/io/output_path.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <unistd.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

namespace fs = std::filesystem;

namespace {

// A rename replaces a link, but what it leads to is meant.
fs::path followed(fs::path file) {
  const std::string name = file.string();
  constexpr int most_links = 40;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(file, error)); ++links) {
    if (links == most_links) throw InvalidInput(name + ": is a symbolic link to itself");
    const fs::path target = fs::read_symlink(file, error);
    if (error) throw FileError(name + ": cannot be followed: " + error.message());
    file = target.is_absolute() ? target : file.parent_path() / target;
  }
  return file;
}

void check_folder(const fs::path& folder, const std::string& name) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) {
    throw FileError(name + ": cannot be written: there is no folder " + folder.string());
  }
  if (!fs::is_directory(status)) {
    throw FileError(name + ": cannot be written: " + folder.string() +
                    (error ? ": " + error.message() : " is not a folder"));
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw FileError(name + ": cannot be written in " + folder.string() + ": " +
                    std::strerror(errno));
  }
}

}  // namespace

fs::path output_file(const fs::path& file, const OutputRules& rules) {
  const std::string name = file.string();
  if (name.empty()) throw InvalidInput("the name of the output is empty");
  if (!file.has_filename()) throw InvalidInput(name + ": is a folder; must be a file");
  const fs::path target = followed(file);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status)) throw InvalidInput(name + ": is a folder; must be a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw InvalidInput(name + ": is not a regular file: nothing can be kept there");
  }
  if (fs::exists(status)) {
    for (const fs::path& input : rules.inputs) {
      if (fs::equivalent(target, input, error)) {
        throw InvalidInput(name + ": is an input of this command" +
                           (file == input ? "" : ", " + input.string()));
      }
    }
    if (!rules.force) throw InvalidInput(name + " exists; " + rules.remedy);
  }
  check_folder(target.has_parent_path() ? target.parent_path() : fs::path("."), name);
  return target;
}

void output_folder(const fs::path& folder, const std::vector<std::string>& files,
                   const OutputRules& rules) {
  const std::string name = folder.string();
  if (name.empty()) throw InvalidInput("the name of the output folder is empty");
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) throw InvalidInput(name + ": is not a folder");
  for (const std::string& file : files) output_file(folder / file, rules);
}

bool make_folder(const fs::path& folder) {
  std::error_code error;
  const bool made = fs::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be made: " + error.message());
  return made;
}

}  // namespace wirepack
