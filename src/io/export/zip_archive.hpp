#pragma once

#include <string>
#include <vector>

namespace wirepack {

/// A file inside of a zip archive.
struct ZipMember {
  std::string name, bytes;
};

/// The bytes of a zip archive of these files, without a date. Throws FileError.
std::string zip_archive(const std::vector<ZipMember>& members);

}  // namespace wirepack
