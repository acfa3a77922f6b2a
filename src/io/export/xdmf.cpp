#include <fmt/format.h>
#include <iterator>

#include "wirepack/core/error.hpp"
#include "wirepack/io/export.hpp"

#include "../xml_text.hpp"

namespace wirepack {

namespace {

// The result as seen from the folder of the target. Links are followed, so that the way also works
// where the folder is one.
std::string way_to_result(const ExportSource& source) {
  const std::filesystem::path folder = std::filesystem::absolute(source.target).parent_path();
  std::string way = std::filesystem::proximate(source.result, folder).string();
  if (way.find(':') != std::string::npos) {
    throw InvalidInput(way + ": XDMF cannot name a file with a colon; rename the result");
  }
  return way;
}

std::string dataset(const std::string& file, const PackingFrame& frame, const std::string& name,
                    const std::string& shape) {
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"Float\" Precision=\"8\" Dimensions=\"{}\">"
      "{}:/frames/{:06.0f}/{}</DataItem>\n",
      shape, file, frame.increment, name);
}

std::string grid(const std::string& file, const PackingFrame& frame) {
  const Index n = frame.rod.node_count();
  std::string text = fmt::format(
      "<Grid Name=\"{:06.0f}\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"Polyline\" NumberOfElements=\"1\" NodesPerElement=\"{}\">\n"
      "<DataItem Format=\"XML\" NumberType=\"Int\" Precision=\"8\" Dimensions=\"1 {}\">",
      frame.increment, frame.inserted_length, n, n);
  auto out = std::back_inserter(text);
  for (Index i = 0; i < n; ++i) out = fmt::format_to(out, "{}{}", i > 0 ? " " : "", i);
  text += "</DataItem>\n</Topology>\n<Geometry GeometryType=\"XYZ\">\n" +
          dataset(file, frame, "position", fmt::format("{} 3", n)) + "</Geometry>\n";
  for (const char* name : {"bend_energy", "twist_energy", "wall_force"}) {
    text +=
        fmt::format("<Attribute Name=\"{}\" AttributeType=\"Scalar\" Center=\"Node\">\n", name) +
        dataset(file, frame, name, std::to_string(n)) + "</Attribute>\n";
  }
  return text + "</Grid>\n";
}

}  // namespace

ExportedFiles export_xdmf(const ExportSource& source) {
  const std::string file = xml_escaped(way_to_result(source));
  std::string text = "<?xml version=\"1.0\"?>\n";
  for (const std::string& line : source.provenance) text += xml_comment(line);
  text += xml_comment("time is the inserted length; energies in force length");
  text +=
      "<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"packing\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const PackingFrame& frame : source.frames) text += grid(file, frame);
  return {{source.target, text + "</Grid>\n</Domain>\n</Xdmf>\n"}};
}

}  // namespace wirepack
