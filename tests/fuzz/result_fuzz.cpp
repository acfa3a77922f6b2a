// Any file is a result, of which all can be read, or is refused.

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"

#include "temporary_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const TemporaryFile file(data, size);
  try {
    const wirepack::Hdf5Reader reader(file.path());
    reader.scenario();
    reader.history();
    for (const std::int64_t increment : reader.frame_increments()) reader.frame(increment);
    reader.progress();
    reader.progress_before();
  } catch (const wirepack::InvalidInput&) {
  } catch (const wirepack::FileError&) {
  }
  return 0;
}
