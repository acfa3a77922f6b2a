#include "text_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "wirepack/core/error.hpp"

namespace wirepack {

std::string read_text(const std::filesystem::path& file, const std::string& what,
                      std::size_t largest) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  const std::string name = file.string();
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InvalidInput(name + ": there is no such file");
  }
  if (error) throw InvalidInput(name + ": " + error.message());
  if (std::filesystem::is_directory(status)) {
    throw InvalidInput(name + ": is a folder; " + what + " is a file");
  }
  // A pipe or device might never end.
  if (!std::filesystem::is_regular_file(status)) {
    throw InvalidInput(name + ": is not a regular file");
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InvalidInput(name + ": cannot be opened: " + std::strerror(errno));
  // as much as there is, which may change while it is read
  std::string text(
      std::min(largest, static_cast<std::size_t>(std::filesystem::file_size(file))) + 1, '\0');
  for (std::size_t filled = 0;;) {
    in.read(text.data() + filled, static_cast<std::streamsize>(text.size() - filled));
    if (in.bad()) throw FileError(name + ": reading failed: " + std::strerror(errno));
    filled += static_cast<std::size_t>(in.gcount());
    const bool all = in.eof() || filled > largest;
    text.resize(all ? filled : std::min(2 * filled, largest + 1));
    if (all) break;
  }
  if (text.size() > largest) {
    throw InvalidInput(name + ": is larger than " + std::to_string(largest / 1'000'000) +
                       " MB, which " + what + " is not");
  }
  return text;
}

}  // namespace wirepack
