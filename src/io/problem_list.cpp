#include "problem_list.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

void require_none(const std::vector<std::string>& problems) {
  if (problems.empty()) return;
  constexpr std::size_t most_shown = 50;
  const std::size_t shown = std::min(problems.size(), most_shown);
  const auto end = problems.begin() + static_cast<std::ptrdiff_t>(shown);
  std::string message = fmt::format("{}", fmt::join(problems.begin(), end, "\n"));
  if (problems.size() > shown) {
    message += fmt::format("\nand {} more problems", problems.size() - shown);
  }
  throw InvalidInput(message);
}

}  // namespace wirepack
