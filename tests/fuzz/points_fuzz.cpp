// Any file holds measured points, or is refused.

#include "wirepack/core/error.hpp"
#include "wirepack/io/points_file.hpp"

#include "file_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileInMemory file(data, size);
  if (!file.good()) return 0;
  try {
    wirepack::read_points(file.path());
  } catch (const wirepack::InvalidInput&) {
  } catch (const wirepack::FileError&) {
  }
  return 0;
}
