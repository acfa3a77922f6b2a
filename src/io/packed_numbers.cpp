#include "packed_numbers.hpp"

#include <cstring>

namespace wirepack {

namespace {

template <class T>
std::vector<unsigned char> byte_planes(const std::vector<T>& numbers) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the lowest byte is taken first");
  std::vector<unsigned char> bytes(numbers.size() * sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    unsigned char of_number[sizeof(T)];
    std::memcpy(of_number, &numbers[i], sizeof(T));
    for (std::size_t k = 0; k < sizeof(T); ++k) bytes[k * numbers.size() + i] = of_number[k];
  }
  return bytes;
}

// Differences wrap around, and so do the sums that undo them.
template <class T>
void take_differences(std::vector<T>& numbers) {
  T before = 0;
  for (T& number : numbers) {
    const T here = number;
    number = static_cast<T>(here - before);
    before = here;
  }
}

}  // namespace

std::vector<unsigned char> packed(const std::vector<float>& numbers) {
  return byte_planes(numbers);
}

std::vector<unsigned char> packed_differences(std::vector<std::int16_t> numbers, int order) {
  for (int k = 0; k < order; ++k) take_differences(numbers);
  std::vector<std::uint16_t> unsigned_numbers;
  unsigned_numbers.reserve(numbers.size());
  for (const std::int16_t d : numbers) {
    unsigned_numbers.push_back(static_cast<std::uint16_t>(d >= 0 ? 2 * d : -2 * d - 1));
  }
  return byte_planes(unsigned_numbers);
}

std::vector<unsigned char> byte_differences(std::vector<unsigned char> bytes) {
  take_differences(bytes);
  return bytes;
}

}  // namespace wirepack
