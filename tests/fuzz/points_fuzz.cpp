// Any file holds measured points, or is refused.

#include "wirepack/core/error.hpp"
#include "wirepack/io/points_file.hpp"

#include "temporary_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const TemporaryFile file(data, size);
  try {
    wirepack::read_points(file.path());
  } catch (const wirepack::InvalidInput&) {
  } catch (const wirepack::FileError&) {
  }
  return 0;
}
