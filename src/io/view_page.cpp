#include "wirepack/io/view_page.hpp"

#include <vector>

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

}  // namespace wirepack
