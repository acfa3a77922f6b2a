#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace wirepack {

/// What the page of a run shows, as JSON that may stand inside of a script element: texts of the
/// file hold no "<" there, so that none can end the element. See write_view_page().
std::string view_data(const std::filesystem::path& result, std::size_t most_frames);

}  // namespace wirepack
