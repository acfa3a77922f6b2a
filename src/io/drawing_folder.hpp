#pragma once

#include <filesystem>

namespace wirepack {

/// A hidden folder beside outputs for other programs to write in, so that no output is ever half a
/// one. It ends with its object. Throws FileError.
class DrawingFolder {
 public:
  explicit DrawingFolder(const std::filesystem::path& beside);
  ~DrawingFolder();
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace wirepack
