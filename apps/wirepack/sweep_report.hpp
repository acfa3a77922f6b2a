#pragma once

#include <filesystem>
#include <string>

#include "sweep_survey.hpp"

namespace wirepack {

/// What has become of the tasks of a folder, as a table.
std::string status_text(const std::filesystem::path& folder, const Survey& tasks);

/// The same as a page with pictures in the folder; returns its path. Throws FileError.
std::filesystem::path write_status_page(const std::filesystem::path& folder, const Survey& tasks);

}  // namespace wirepack
