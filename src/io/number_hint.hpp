#pragma once

#include <string>
#include <string_view>

namespace wirepack {

/// What to write for a word that was meant as a number: "; write 0.2" for ".2", "5.", "20%", "0,2";
/// empty for others.
std::string number_hint(std::string_view word);

}  // namespace wirepack
