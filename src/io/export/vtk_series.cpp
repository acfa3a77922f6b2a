#include <cstdint>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "wirepack/io/export.hpp"

#include "../base64.hpp"
#include "../node_values.hpp"
#include "../xml_text.hpp"
#include "bytes.hpp"

namespace wirepack {

namespace {

// The content of a DataArray: the number of bytes, then the bytes.
template <class T, class Values>
std::string content(const Values& values) {
  std::string bytes;
  for (const auto& value : values) append_bytes(bytes, static_cast<T>(value));
  std::string length;
  append_bytes(length, static_cast<std::uint64_t>(bytes.size()));
  const std::string all = length + bytes;
  return base64({reinterpret_cast<const unsigned char*>(all.data()), all.size()});
}

// The unit comes last: readers want the data first.
std::string array(const std::string& attributes, const std::string& unit, const std::string& data) {
  std::string text = "<DataArray " + attributes + " format=\"binary\">" + data;
  if (!unit.empty()) {
    text += "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">" + unit +
            "</InformationKey>";
  }
  return text + "</DataArray>\n";
}

std::string field(const std::string& name, const std::string& unit, double value) {
  return array("type=\"Float64\" Name=\"" + name + "\" NumberOfTuples=\"1\"", unit,
               content<double>(std::vector<double>{value}));
}

std::string comments(const ExportSource& source) {
  std::string text;
  for (const std::string& line : source.provenance) text += xml_comment(line);
  return text;
}

std::string head(std::string_view type) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n",
      type);
}

std::string poly_data(const ExportSource& source, const PackingFrame& frame) {
  const Index n = frame.rod.node_count();
  std::vector<std::int64_t> connectivity(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) connectivity[static_cast<std::size_t>(i)] = i;
  std::string text = head("PolyData") + comments(source) + "<PolyData>\n<FieldData>\n";
  text += field("increment", "", frame.increment) +
          field("inserted_length", "length", frame.inserted_length) +
          field("packing_density", "", frame.packing_density) +
          field("force", "force", frame.force) +
          field("cavity_radius", "length", source.scenario.cavity.radius);
  text += fmt::format(
      "</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"1\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Scalars=\"scaled_bend_energy\">\n",
      n);
  const auto scalar = [&](const std::string& name, const std::string& unit,
                          const Eigen::VectorXd& values) {
    text += array("type=\"Float32\" Name=\"" + name + "\"", unit, content<float>(values));
  };
  for (const NodeValue& value : node_values(source.scenario, frame)) {
    scalar(value.name, value.unit, value.values);
  }
  scalar("radius", "length", Eigen::VectorXd::Constant(n, source.scenario.wire.radius));
  text += "</PointData>\n<Points>\n" +
          array("type=\"Float64\" Name=\"position\" NumberOfComponents=\"3\"", "length",
                content<double>(frame.rod.nodes.reshaped())) +
          "</Points>\n<Lines>\n" +
          array("type=\"Int64\" Name=\"connectivity\"", "", content<std::int64_t>(connectivity)) +
          array("type=\"Int64\" Name=\"offsets\"", "",
                content<std::int64_t>(std::vector<std::int64_t>{n}));
  return text + "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

ExportedFiles export_vtk(const ExportSource& source) {
  std::filesystem::path folder = source.target;
  folder.replace_extension();
  std::string collection = head("Collection") + comments(source) + "<Collection>\n";
  ExportedFiles files;
  for (const PackingFrame& frame : source.frames) {
    const std::string name = fmt::format("{:06.0f}.vtp", frame.increment);
    files.push_back({folder / name, poly_data(source, frame)});
    const std::string relative = (folder.filename() / name).string();
    collection += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                              frame.inserted_length, xml_escaped(relative));
  }
  files.push_back({source.target, collection + "</Collection>\n</VTKFile>\n"});
  return files;
}

}  // namespace wirepack
