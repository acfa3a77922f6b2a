#pragma once

#include <filesystem>

namespace wirepack {

/// Writes a page that shows a run in a browser: HTML in one file that needs no other and no
/// network. Of the saved frames at most `most_frames` are taken, evenly spread and the last one
/// among them. Positions are rounded to 1/32767 of the cavity's radius, what colours the nodes to 4
/// %. Throws FileError when `result` is none (see Hdf5Reader) or holds no frame yet, or when `page`
/// cannot be written; then `page` is as it was.
void write_view_page(const std::filesystem::path& result, const std::filesystem::path& page,
                     std::size_t most_frames);

/// The page of a run to which another page links: written only where it is missing or older than
/// the result; of so few frames that it takes some megabytes at most. Throws as write_view_page()
/// does, and InvalidInput where the page can be no file (see output_file).
void update_view_page(const std::filesystem::path& result, const std::filesystem::path& page);

}  // namespace wirepack
