#include "hdf5_safety.hpp"

#include <algorithm>
#include <array>

namespace wirepack {

namespace {

// HDF5 takes memory for whole chunks, be there ever so little in them.
constexpr hsize_t most_rows_beyond = 256;
constexpr int most_dimensions = 2;

struct Walk {
  hsize_t file_size;
  std::string problem;
};

hsize_t product(const std::array<hsize_t, most_dimensions>& size, hsize_t limit) {
  hsize_t result = 1;
  for (const hsize_t n : size) {
    if (n != 0 && result > limit / n) return limit + 1;
    result *= n;
  }
  return result;
}

bool has_known_filters(hid_t properties) {
  constexpr std::array known{H5Z_FILTER_FLETCHER32, H5Z_FILTER_SHUFFLE, H5Z_FILTER_DEFLATE};
  for (int k = 0; k < H5Pget_nfilters(properties); ++k) {
    unsigned flags = 0, filter_flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(k), &flags,
                                               &values, nullptr, 0, nullptr, &filter_flags);
    if (std::find(known.begin(), known.end(), filter) == known.end()) return false;
  }
  return true;
}

std::string problem_of_dataset(hid_t dataset, hsize_t file_size) {
  const Hdf5Handle properties(H5Dget_create_plist(dataset), H5Pclose, "opening a dataset");
  const H5D_layout_t layout = H5Pget_layout(properties);
  if (layout == H5D_VIRTUAL || H5Pget_external_count(properties) != 0) {
    return "has its values in other files";
  }
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, "opening a dataset");
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, "opening a dataset");
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0 || rank > most_dimensions) return "has an unexpected shape";
  std::array<hsize_t, most_dimensions> size{1, 1};
  hdf5_checked(H5Sget_simple_extent_dims(space, size.data(), nullptr), "opening a dataset");
  const hsize_t width = H5Tget_size(type);
  if (product(size, file_size) > file_size / std::max<hsize_t>(width, 1)) {
    return "is said to be larger than the file";
  }
  if (layout != H5D_CHUNKED) return "";
  std::array<hsize_t, most_dimensions> chunk{1, 1};
  hdf5_checked(H5Pget_chunk(properties, most_dimensions, chunk.data()), "opening a dataset");
  if (chunk[0] > std::max(size[0], most_rows_beyond) || chunk[1] > std::max<hsize_t>(size[1], 1)) {
    return "has chunks of an unexpected size";
  }
  return has_known_filters(properties) ? "" : "is coded in an unknown way";
}

herr_t look_at_link(hid_t group, const char* name, const H5L_info_t* info, void* data) {
  Walk& walk = *static_cast<Walk*>(data);
  try {
    if (info->type != H5L_TYPE_HARD) {
      walk.problem = "is a link that may lead elsewhere";
    } else {
      const Hdf5Handle object(H5Oopen(group, name, H5P_DEFAULT), H5Oclose, "opening an object");
      if (H5Iget_type(object) == H5I_DATASET) {
        walk.problem = problem_of_dataset(object, walk.file_size);
      }
    }
  } catch (const FileError&) {
    walk.problem = "cannot be opened";
  }
  if (walk.problem.empty()) return 0;
  walk.problem = std::string(name) + " " + walk.problem;
  return 1;
}

}  // namespace

void check_safety(hid_t file) {
  Walk walk{};
  hdf5_checked(H5Fget_filesize(file, &walk.file_size), "reading its size");
  const herr_t end = H5Lvisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, look_at_link, &walk);
  hdf5_checked(end, "listing what it has");
  if (!walk.problem.empty()) throw FileError(walk.problem);
}

}  // namespace wirepack
