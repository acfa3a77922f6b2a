#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

class Hdf5Reader;

/// What is exported of a result, and where to.
struct ExportSource {
  std::filesystem::path result;         ///< the result file
  std::filesystem::path target;         ///< the file that the user asks for
  std::vector<std::string> provenance;  ///< lines on origin and units, without control characters
  Scenario scenario;
  std::vector<HistoryRow> history;
  std::vector<PackingFrame> frames;  ///< in order; formats of one frame take the last
  std::optional<double> voxel_size;  ///< of export_voxels; default: a / 4, or R / 128 if larger
};

/// Reads what formats need of a result, with frames of these increments. Throws FileError.
ExportSource export_source(const Hdf5Reader& reader, const std::filesystem::path& result,
                           const std::filesystem::path& target,
                           const std::vector<std::int64_t>& increments);

/// One file of an export.
struct ExportedFile {
  std::filesystem::path path;
  std::string bytes;
};
/// In the order in which they are to be written: files that name others come last.
using ExportedFiles = std::vector<ExportedFile>;

/// Writes each file as a whole, making its folder where that is missing; removes again what it has
/// put where nothing was when it fails. Throws FileError with path and reason.
void write_files(const ExportedFiles& files);

// The formats. Coordinates and numbers are in the units of the configuration, whatever unit a
// reader takes them for; the provenance stands in the comments of each. A tube has flat ends.

/// VTK PolyData per frame, TARGET without its ending /000123.vtp, and TARGET, the .pvd collection
/// that lists them by inserted length: a polyline with node values and their units.
ExportedFiles export_vtk(const ExportSource& source);
/// XDMF that refers to the frames inside of the result. Throws InvalidInput where its name holds a
/// colon, which XDMF cannot express.
ExportedFiles export_xdmf(const ExportSource& source);
/// Extended XYZ: a block per frame, one particle of the wire's radius per node, with node values.
ExportedFiles export_xyz(const ExportSource& source);
/// Binary STL of the tube, closed, facing outwards. Its polygons of 16 sides have the area of the
/// wire's cross-section.
ExportedFiles export_stl(const ExportSource& source);
/// Binary PLY of the same tube, coloured like the packing figure, with the scaled bending energy.
ExportedFiles export_ply(const ExportSource& source);
/// 3MF with the beam lattice extension: the nodes, and a beam of the wire's radius per edge.
ExportedFiles export_3mf(const ExportSource& source);
/// MetaImage (.mhd and .raw) of the cube about the cavity: the part of each voxel that the wire
/// fills, 0 to 255. Throws InvalidInput for a voxel size that needs more than 1024 voxels a side.
ExportedFiles export_voxels(const ExportSource& source);
/// mmCIF: a chain of one bead per node, bonded to the next, the scaled bending energy as B factor.
ExportedFiles export_mmcif(const ExportSource& source);
/// The history as comma-separated values: names of the columns in the first line without #, units
/// in the last with #.
ExportedFiles export_csv(const ExportSource& source);

}  // namespace wirepack
