#pragma once

#include <fmt/format.h>
#include <string_view>

#include "wirepack/core/error.hpp"

namespace wirepack {

/// To be thrown where points allow more than one shape, or none.
inline InvalidInput cannot_tell(std::string_view reason) {
  return InvalidInput(fmt::format("the points cannot tell the shape: {}", reason));
}

/// A reason, and what may be done about it.
constexpr std::string_view no_order =
    "they come in no order that tells turns apart; give them in order, with --ordered, or with "
    "their arc lengths";

}  // namespace wirepack
