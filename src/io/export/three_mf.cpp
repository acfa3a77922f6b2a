#include <fmt/format.h>
#include <iterator>

#include "wirepack/io/export.hpp"

#include "../xml_text.hpp"
#include "zip_archive.hpp"

namespace wirepack {

namespace {

constexpr const char* content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";

constexpr const char* relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

// Beams end in balls where they meet, which fills the joints, and flat at the ends of the wire.
std::string beam(Index edge, Index edges) {
  const auto cap = [](bool at_end) { return at_end ? "butt" : "sphere"; };
  return fmt::format("<b:beam v1=\"{}\" v2=\"{}\" cap1=\"{}\" cap2=\"{}\"/>\n", edge, edge + 1,
                     cap(edge == 0), cap(edge + 1 == edges));
}

std::string model(const ExportSource& source) {
  const Points& nodes = source.frames.back().rod.nodes;
  const double a = source.scenario.wire.radius,
               shift = semi_axes_of(source.scenario.cavity).maxCoeff();
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" requiredextensions=\"b\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\">\n"
      "<metadata name=\"Application\">wirepack</metadata>\n<metadata name=\"Description\">";
  for (const std::string& line : source.provenance) text += xml_escaped(line) + "; ";
  text +=
      "a unit of length stands as a millimeter</metadata>\n"
      "<resources>\n<object id=\"1\" name=\"wire\" type=\"model\">\n<mesh>\n<vertices>\n";
  auto out = std::back_inserter(text);
  for (Index i = 0; i < nodes.cols(); ++i) {
    const Eigen::Vector3f p = nodes.col(i).cast<float>();
    out = fmt::format_to(out, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x(), p.y(), p.z());
  }
  text += fmt::format(
      "</vertices>\n<triangles/>\n<b:beamlattice radius=\"{}\" minlength=\"{}\">\n<b:beams>\n", a,
      1e-6 * a);
  for (Index j = 0; j + 1 < nodes.cols(); ++j) text += beam(j, nodes.cols() - 1);
  // build items lie where no coordinate is negative
  return text + fmt::format(
                    "</b:beams>\n</b:beamlattice>\n</mesh>\n</object>\n</resources>\n<build>\n"
                    "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 {0} {0} {0}\"/>\n"
                    "</build>\n</model>\n",
                    shift);
}

}  // namespace

ExportedFiles export_3mf(const ExportSource& source) {
  return {{source.target, zip_archive({{"[Content_Types].xml", content_types},
                                       {"_rels/.rels", relationships},
                                       {"3D/3dmodel.model", model(source)}})}};
}

}  // namespace wirepack
