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
  std::vector<HistoryRow> history;  ///< a row at least
  PackingFrame frame;               ///< the one that is shown
};

/// A figure on disk: the plain data and the gnuplot script that draws it to NAME.png, NAME.pdf and
/// NAME.svg in the same folder. The script runs on its own: `gnuplot NAME.gp`.
/// All functions throw FileError when something cannot be written, or gnuplot fails or is missing.

/// What figures of these names put in their folder. Figures that are there are replaced, each as a
/// whole.
std::vector<std::string> figure_files(const std::vector<std::string>& names);

/// packing: the wire of a run's frame from outside, in the outline of its cavity, and cut open at
/// y = 0, coloured by bending energy per length over YI / (2 R^2). Runs of both setups, the first
/// of each, are drawn side by side, in colours of one range.
void draw_packing(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

/// force: F R^2 / YI against the packing density, with the inverse-spool model; log axis. Here and
/// below runs that differ in their seeds alone are one curve: their mean, in a band of its standard
/// error.
void draw_force(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

/// energy: E_bend R / YI against the packing density, with the same model, and E_twist R / YI in an
/// inset, where the runs have torsional energy.
void draw_energy(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

/// torsion: E_twist R / YI against the packing density; log axis. Where the runs have no torsional
/// energy nothing is drawn, and false is returned.
bool draw_torsion(const std::filesystem::path& folder, const std::vector<FigureRun>& runs);

/// How phi_max is read: the packing density at which F R^2 / YI first reaches a threshold after the
/// first coil, as a mean over the wire fed last: an edge of it, or `fed_over_radius` times R where
/// that is longer.
struct PhiMaxThreshold {
  double scaled_force = 10;
  double fed_over_radius = 0;
};

/// phi_max against a / R; log axes. With power laws fitted to the runs of
/// either setup, published numbers (data/published), and the mass of the wire against R in an
/// inset: over that of a ball of its radius it is phi_max (R/a)^3. Where no run reaches the
/// threshold nothing is drawn, where no series reaches it at two radii no inset.
enum class PhiMaxFigure { none, without_inset, whole };
PhiMaxFigure draw_phi_max(const std::filesystem::path& folder, const std::vector<FigureRun>& runs,
                          const PhiMaxThreshold& threshold);

/// bend_distribution: how the bending energies of the shown frames' joints over their mean are
/// spread, with the log-normal law of greatest likelihood, and the published one.
void draw_bend_distribution(const std::filesystem::path& folder,
                            const std::vector<FigureRun>& runs);

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
