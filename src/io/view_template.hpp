#pragma once

#include <string_view>

namespace wirepack {

/// The page of `wirepack view` without its data, made of the files in src/io/view when the program
/// is built.
extern const std::string_view view_template;

/// Stands once in view_template, where the data belong: inside of a script element of type
/// application/json.
inline constexpr std::string_view view_data_mark = "@WIREPACK_DATA@";

}  // namespace wirepack
