#pragma once

#include <string>
#include <string_view>

namespace wirepack {

/// Text as it stands in XML and HTML, between tags or in a quoted attribute. Control characters,
/// which XML cannot hold, become blanks.
std::string xml_escaped(std::string_view text);

/// Text as it stands in a comment of XML, where two hyphens must not meet.
std::string xml_comment(std::string_view text);

}  // namespace wirepack
