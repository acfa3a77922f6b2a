#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirepack/rod/reference_shape.hpp"

#include "toml_text.hpp"

namespace wirepack {

/// The rows of [[s, k1, k2, k3], ...]; nothing when an array is not of that form.
std::optional<std::vector<DarbouxRow>> darboux_rows(const toml::array& array);

/// As TOML, one row to a line, and a number in the shortest form that reads back to the same bits.
std::string text_of(const std::vector<DarbouxRow>& rows);
std::string text_of(double number);

}  // namespace wirepack
