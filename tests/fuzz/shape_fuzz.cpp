// Any file is a shape, or is refused.

#include "wirepack/core/error.hpp"
#include "wirepack/io/shape_file.hpp"

#include "file_in_memory.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const FileInMemory file(data, size);
  if (!file.good()) return 0;
  try {
    wirepack::read_shape(file.path());
  } catch (const wirepack::InvalidInput&) {
  } catch (const wirepack::FileError&) {
  }
  return 0;
}
