#pragma once

#include <string_view>

namespace wirepack {

// data/published/published.gp: published numbers with their sources, as gnuplot reads them.
extern const std::string_view published_numbers;

}  // namespace wirepack
