// Any text is a configuration, or is refused; what is one is written out and read back as the same.

#include <cstdlib>
#include <string_view>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // shapes would be read from other files
  if (text.find("reference_shape") != std::string_view::npos) return 0;
  std::string written;
  try {
    written = wirepack::resolved_config(wirepack::parse_config(text, "fuzz"));
  } catch (const wirepack::InvalidInput&) {
    return 0;
  }
  if (wirepack::resolved_config(wirepack::parse_config(written, "again")) != written) std::abort();
  return 0;
}
