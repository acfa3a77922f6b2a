#include <fmt/format.h>
#include <iterator>

#include "wirepack/io/export.hpp"

#include "../node_values.hpp"

namespace wirepack {

namespace {

std::string quoted_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string block(const ExportSource& source, const PackingFrame& frame) {
  const std::vector<NodeValue> values = node_values(source.scenario, frame);
  const Index n = frame.rod.node_count();
  std::string text = fmt::format("{}\nProperties=species:S:1:pos:R:3:radius:R:1", n);
  for (const NodeValue& value : values) text += fmt::format(":{}:R:1", value.name);
  text +=
      fmt::format(" pbc=\"F F F\" increment={:.0f} inserted_length={} packing_density={} force={}",
                  frame.increment, frame.inserted_length, frame.packing_density, frame.force);
  std::string units = "position length, radius length";
  for (const NodeValue& value : values) units += ", " + value.name + " " + value.unit;
  text += " units=" + quoted_text(units);
  for (std::size_t i = 0; i < source.provenance.size(); ++i) {
    text += fmt::format(" provenance_{}={}", i + 1, quoted_text(source.provenance[i]));
  }
  text += "\n";
  auto out = std::back_inserter(text);
  for (Index i = 0; i < n; ++i) {
    const Vec3 p = frame.rod.nodes.col(i);
    out = fmt::format_to(out, "X {} {} {} {}", p.x(), p.y(), p.z(), source.scenario.wire.radius);
    for (const NodeValue& value : values) out = fmt::format_to(out, " {:.9g}", value.values[i]);
    *out++ = '\n';
  }
  return text;
}

}  // namespace

ExportedFiles export_xyz(const ExportSource& source) {
  std::string text;
  for (const PackingFrame& frame : source.frames) text += block(source, frame);
  return {{source.target, text}};
}

}  // namespace wirepack
