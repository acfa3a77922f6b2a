#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "wirepack/core/error.hpp"
#include "wirepack/fit/shape_fit.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/points_file.hpp"
#include "wirepack/io/shape_file.hpp"

#include "command.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

const std::map<std::string, ShapeModel> models{
    {"circle", ShapeModel::circle}, {"helix", ShapeModel::helix}, {"spline", ShapeModel::spline}};

struct Options {
  std::string points, model, output, figures, command_line;
  std::vector<std::string> columns;
  bool ordered = false, robust = false, json = false, force = false;
  Index intervals = 0;
};

void say(const std::string& message) { print_message("wirepack fit: " + message); }

std::string number_line(const ShapeNumber& number) {
  if (number.fixed) return fmt::format("{:<14} {:>16}   by the model\n", number.name, number.value);
  if (!number.determined) return fmt::format("{:<14} {:>16}\n", number.name, "not determined");
  return fmt::format("{:<14} {:>16.9g}   +- {:.3g}\n", number.name, number.value,
                     number.standard_error);
}

std::string place(const MeasuredPoints& points, Index i) {
  return points.line.empty() ? fmt::format("point {}", i + 1)
                             : fmt::format("line {}", points.line[static_cast<std::size_t>(i)]);
}

std::string table(const ShapeFit& fit, const MeasuredPoints& points, const std::string& model) {
  std::string text =
      fmt::format("{:<14} {:>16}\n{:<14} {:>16}\n", "model", model, "points", points.count());
  for (const ShapeNumber& number : fit.numbers) text += number_line(number);
  text += fmt::format("{:<14} {:>16.9g}\n", "length", fit.length);
  if (fit.intervals > 0) text += fmt::format("{:<14} {:>16}\n", "intervals", fit.intervals);
  text += fmt::format("{:<14} {:>16.4g}   root mean square of the distances\n", "residual_rms",
                      fit.residual_rms);
  if (fit.chi_square) {
    text += fmt::format("{:<14} {:>16.6g}   with {} degrees of freedom\n", "chi_square",
                        *fit.chi_square, fit.degrees_of_freedom);
  } else {
    text += fmt::format("{:<14} {:>16.4g}   per coordinate, with {} degrees of freedom\n", "noise",
                        fit.noise, fit.degrees_of_freedom);
  }
  Index worst = 0;
  const double largest = fit.distance.maxCoeff(&worst);
  text += fmt::format("{:<14} {:>16.4g}   {}\n", "largest", largest, place(points, worst));
  for (std::size_t i = 0; i < fit.numbers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double value = fit.correlation(static_cast<Index>(i), static_cast<Index>(j));
      if (value == 0) continue;
      text += fmt::format("{:<14} {:>16.4f}   {} and {}\n", "correlation", value,
                          fit.numbers[j].name, fit.numbers[i].name);
    }
  }
  return text;
}

std::string json_text(const ShapeFit& fit, const MeasuredPoints& points, const std::string& model) {
  using Json = nlohmann::ordered_json;
  Json result;
  result["model"] = model;
  Json parameters = Json::object();
  for (const ShapeNumber& number : fit.numbers) {
    Json entry;
    entry["value"] = number.determined ? Json(number.value) : Json(nullptr);
    entry["standard_error"] = number.determined ? Json(number.standard_error) : Json(nullptr);
    if (number.fixed) entry["fixed"] = true;
    parameters[number.name] = entry;
  }
  result["parameters"] = parameters;
  Json correlation = Json::array();
  for (Index i = 0; i < fit.correlation.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < fit.correlation.cols(); ++j) row.push_back(fit.correlation(i, j));
    correlation.push_back(row);
  }
  result["correlation"] = correlation;
  result["length"] = fit.length;
  result["residual_rms"] = fit.residual_rms;
  result["noise"] = fit.noise;
  if (fit.chi_square) result["chi_square"] = *fit.chi_square;
  result["degrees_of_freedom"] = fit.degrees_of_freedom;
  result["unknowns"] = fit.unknowns;
  result["rank"] = fit.rank;
  if (fit.intervals > 0) result["intervals"] = fit.intervals;
  result["largest_residual"] = fit.distance.maxCoeff();
  Json outliers = Json::array();
  for (const Index i : fit.outliers) {
    outliers.push_back(points.line.empty() ? i + 1 : points.line[static_cast<std::size_t>(i)]);
  }
  result["outlier_lines"] = outliers;
  result["left_out"] = fit.left_out.size();
  result["misfit"] = fit.misfit.empty() ? Json(nullptr) : Json(fit.misfit);
  result["planar"] = fit.planar;
  result["closed"] = fit.closed;
  result["points"] = points.count();
  return result.dump(2) + "\n";
}

void say_what_is_hidden(const ShapeFit& fit) {
  std::string hidden;
  bool bent = true;
  for (const ShapeNumber& number : fit.numbers) {
    if (!number.determined) hidden += (hidden.empty() ? "" : ", ") + number.name;
    if (number.name == "radius") bent = number.determined;
  }
  if (fit.planar) {
    say("the points scatter in one plane only, as those of a picture do: the errors are those of "
        "the plane");
  }
  if (hidden.empty()) return;
  if (fit.planar && bent) {
    say("points in a plane do not tell " + hidden);
  } else if (fit.model != ShapeModel::spline) {
    say("the points lie on a straight line within their scatter: they do not tell " + hidden);
  } else {
    say("the wire is straight somewhere, within the scatter of the points: they do not tell " +
        hidden);
  }
}

void say_what_is_off(const ShapeFit& fit, const MeasuredPoints& points) {
  if (!fit.misfit.empty()) {
    say(fmt::format("the model does not fit these points: {}{}", fit.misfit,
                    fit.model == ShapeModel::circle  ? "; a helix or a spline may"
                    : fit.model == ShapeModel::helix ? "; a spline may"
                                                     : ""));
  }
  if (fit.outliers.empty()) return;
  std::string lines;
  for (std::size_t k = 0; k < std::min<std::size_t>(fit.outliers.size(), 10); ++k) {
    lines += fmt::format("{}{} ({:.3g})", k > 0 ? ", " : "", place(points, fit.outliers[k]),
                         fit.distance[fit.outliers[k]]);
  }
  if (fit.outliers.size() > 10) lines += ", ...";
  say(fmt::format("{} of the points lie too far off for their number: {}", fit.outliers.size(),
                  lines));
  if (!fit.left_out.empty()) {
    say(fmt::format(
        "{} of them, far from all others or from the neighbours in the list, {} left out: {}",
        fit.left_out.size(), fit.left_out.size() == 1 ? "is" : "are",
        place(points, fit.left_out.front()) + (fit.left_out.size() > 1 ? ", ..." : "")));
  }
}

void say_what_to_know(const ShapeFit& fit, const MeasuredPoints& points) {
  say_what_is_hidden(fit);
  if (fit.rank < fit.unknowns) {
    say(fmt::format("the points tell {} of the {} unknowns of the fit", fit.rank, fit.unknowns));
  }
  if (fit.closed) {
    say(fit.model == ShapeModel::circle ? "the points close a circle" : "the points close a loop");
  }
  say_what_is_off(fit, points);
}

int fit(const Options& options) {
  MeasuredPoints points = read_points(options.points, options.columns);
  points.ordered = options.ordered;
  FitOptions how;
  how.model = models.at(options.model);
  how.robust = options.robust;
  if (options.intervals != 0) how.intervals = options.intervals;
  if (how.intervals && how.model != ShapeModel::spline) {
    throw InvalidInput("--intervals is for --model spline");
  }
  const OutputRules rules{{options.points}, options.force};
  const std::filesystem::path shape = output_file(options.output, rules);
  if (!options.figures.empty()) output_folder(options.figures, figure_files({"fit"}), rules);
  ShapeFit result;
  try {
    result = fit_shape(points, how);
  } catch (const InvalidInput& error) {
    throw InvalidInput(options.points + ": " + error.what());
  }
  if (!result.converged) {
    throw NumericalFailure(options.points + ": the fit does not converge; no shape is written");
  }
  if (!options.figures.empty()) draw_fit(options.figures, points, result);
  write_shape(shape, result, {options.points, options.command_line});
  std::fputs((options.json ? json_text(result, points, options.model)
                           : table(result, points, options.model))
                 .c_str(),
             stdout);
  say_what_to_know(result, points);
  return exit_done;
}

}  // namespace

Command fit_command(CLI::App& program, const std::string& command_line) {
  CLI::App* app = program.add_subcommand(
      "fit", "Stress-free shape of a wire from points measured on it, for wire.reference_shape");
  const auto options = std::make_shared<Options>();
  options->command_line = command_line;
  app->set_help_flag("--help,-h", "This help");
  app->add_option(
         "POINTS.csv", options->points,
         "x, y, z of a point per line, and arc length and standard error, if known; text with or "
         "without a header, or markups of 3D Slicer (.fcsv, .mrk.json)")
      ->required();
  app->add_option("--model", options->model, "circle, helix, or spline (bending that changes)")
      ->required()
      ->type_name("circle|helix|spline")
      ->check(CLI::IsMember({"circle", "helix", "spline"}).description(""));
  app->add_option("-o,--output", options->output, "The shape")->required()->type_name("SHAPE.toml");
  app->add_flag("--force", options->force, "Replaces an existing SHAPE.toml and figures");
  app->add_option("--columns", options->columns,
                  "Which columns are x, y, z[, arc[, sigma]]: their names, or numbers from 1")
      ->delimiter(',')
      ->type_name("X,Y,Z")
      ->allow_extra_args(false);
  app->add_flag("--ordered", options->ordered,
                "The points come in order along the wire, whatever it looks like");
  app->add_flag("--robust", options->robust,
                "Points far off count by their distance, not by its square (Huber)");
  app->add_option("--intervals", options->intervals,
                  "Knot intervals of the spline; chosen by Schwarz's criterion if not given")
      ->type_name("N")
      ->check(CLI::Range(Index{1}, most_intervals));
  app->add_option("--figures", options->figures,
                  "Folder for a picture of points, shape and residuals (PNG, PDF, SVG)")
      ->type_name("DIR");
  app->add_flag("--json", options->json, "Prints the result as JSON instead of a table");
  app->footer(
      "Example: wirepack fit data/shapes/helix.csv --model helix -o helix.toml --figures figures");
  return {app, [options] { return fit(*options); }};
}

}  // namespace wirepack
