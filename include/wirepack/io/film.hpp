#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/io/hdf5_reader.hpp"

namespace wirepack {

/// Names in FOLDER/film that a film takes: 0001.png and so on, one for each saved frame of the run,
/// or `most_frames`, which are evenly spread then, the last one among them; and those of the
/// pictures of an earlier film, which are removed.
std::vector<std::string> film_pictures(const std::filesystem::path& folder,
                                       const Hdf5Reader& reader, std::size_t most_frames);

/// What it takes to make film.mp4 of them: a command of ffmpeg, for the folder that holds film/.
std::string film_command();

/// Draws those frames as the figure `packing`, from one side, in one range of colours, with packing
/// density and force written in, to FOLDER/film/0001.png and so on, and lets ffmpeg make
/// FOLDER/film.mp4 of them (H.264); false: ffmpeg is not on PATH. What there is of an earlier film
/// in the folder is removed. Throws FileError when something cannot be written, or gnuplot or
/// ffmpeg fails.
bool draw_film(const std::filesystem::path& folder, const Hdf5Reader& reader,
               std::size_t most_frames);

}  // namespace wirepack
