#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"
#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// One run as figures need it.
struct FigureRun {
  std::string label;
  Scenario scenario;
  std::vector<HistoryRow> history;
};

/// A figure on disk: the plain data and the gnuplot script that draws it to NAME.png, NAME.pdf and
/// NAME.svg in the same folder. The script runs on its own: `gnuplot NAME.gp`.
/// All functions throw FileError when something cannot be written, or gnuplot fails or is missing.

/// What figures of these names put in their folder. Figures that are there are replaced, each as a
/// whole.
std::vector<std::string> figure_files(const std::vector<std::string>& names);

/// packing: the wire of a frame as a tube in the outline of its cavity, coloured by bending energy per
/// length over YI / (2 R^2).
void draw_packing(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame);

/// section: where the plane y = 0 cuts the wire of a frame, in the same colours.
void draw_section(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame);

/// force: F R^2 / YI against the packing density, with the inverse-spool model; log axis.
void draw_force(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

/// energy: E_bend R / YI and E_twist R / YI against the packing density, with the same model.
void draw_energy(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

enum class Stroke { thin_line, dashed_line, marks };
/// One curve of a figure against the packing density; no label: not in the key. Colour 0 is black.
struct Curve {
  std::string label;
  std::vector<std::array<double, 2>> points;
  int colour = 1;
  Stroke stroke = Stroke::thin_line;
};
/// NAME: curves against the packing density.
void draw_curves(const std::filesystem::path& folder, const std::string& name,
                 const std::string& quantity, const std::vector<Curve>& curves);

/// fit: measured points with the fitted shape, and the distances of the points along it.
void draw_fit(const std::filesystem::path& folder, const MeasuredPoints& points,
              const ShapeFit& fit);

}  // namespace wirepack
