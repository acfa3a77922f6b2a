#include "wirepack/io/view_page.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"
#include "view_data.hpp"
#include "view_template.hpp"

namespace wirepack {

void write_view_page(const std::filesystem::path& result, const std::filesystem::path& page,
                     std::size_t most_frames) {
  const std::string data = view_data(result, most_frames);
  const std::size_t mark = view_template.find(view_data_mark);
  std::vector<char> bytes(view_template.begin(), view_template.end());
  const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(mark);
  bytes.insert(bytes.erase(at, at + static_cast<std::ptrdiff_t>(view_data_mark.size())),
               data.begin(), data.end());
  replace_file(page, bytes);
}

namespace {

// A page has about six bytes for a node of a frame.
std::size_t frames_of_a_bounded_page(const std::filesystem::path& result) {
  constexpr Index most_nodes = 600'000, most_frames = 40;
  const Hdf5Reader reader(result);
  const std::vector<std::int64_t> frames = reader.frame_increments();
  const Index nodes = frames.empty() ? 1 : reader.frame(frames.back()).rod.node_count();
  return static_cast<std::size_t>(std::clamp<Index>(most_nodes / nodes, 1, most_frames));
}

}  // namespace

void update_view_page(const std::filesystem::path& result, const std::filesystem::path& page) {
  const std::filesystem::path target = output_file(page, {.inputs = {result}, .force = true});
  std::error_code missing;
  const auto made = std::filesystem::last_write_time(target, missing);
  if (!missing && made >= std::filesystem::last_write_time(result, missing)) return;
  write_view_page(result, target, frames_of_a_bounded_page(result));
}

}  // namespace wirepack
