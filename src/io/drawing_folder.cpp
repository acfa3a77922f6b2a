#include "drawing_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "wirepack/core/error.hpp"

namespace wirepack {

DrawingFolder::DrawingFolder(const std::filesystem::path& beside) {
  std::string name = (beside / ".figure.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw FileError(beside.string() + ": cannot be written: " + std::strerror(errno));
  }
  path_ = name;
}

DrawingFolder::~DrawingFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace wirepack
