// Any file is a shape, or is refused.

#include "wirepack/core/error.hpp"
#include "wirepack/io/shape_file.hpp"

#include "temporary_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const TemporaryFile file(data, size);
  try {
    wirepack::read_shape(file.path());
  } catch (const wirepack::InvalidInput&) {
  } catch (const wirepack::FileError&) {
  }
  return 0;
}
