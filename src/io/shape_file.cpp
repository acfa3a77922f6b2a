#include "wirepack/io/shape_file.hpp"

#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/version.hpp"

#include "atomic_file.hpp"
#include "darboux_rows.hpp"
#include "text_file.hpp"
#include "toml_text.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_shape = 10'000'000;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\u{:04X}", code);
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + '"';
}

std::string_view name_of(ShapeModel model) {
  switch (model) {
    case ShapeModel::circle:
      return "circle";
    case ShapeModel::helix:
      return "helix";
    case ShapeModel::spline:
      return "spline";
  }
  return "";
}

}  // namespace

std::string shape_text(const ShapeFit& fit, const ShapeOrigin& origin) {
  std::string text =
      "# Stress-free shape of a wire, for wire.reference_shape. k0 = (k1, k2, k3) is its Darboux\n"
      "# vector by the arc s from the first point, in a frame whose third axis is the tangent;\n"
      "# linear between rows. k3 > 0 is right-handed. The first point is the tip, which enters a\n"
      "# cavity first.\n[shape]\n";
  const auto line = [&](std::string_view key, const std::string& value) {
    text += fmt::format("{} = {}\n", key, value);
  };
  line("model", quoted(std::string(name_of(fit.model))));
  line("length", text_of(fit.shape.table.length()));
  line("k0", text_of(fit.shape.table.rows()));
  text += fit.model == ShapeModel::spline ? "\n# means along the wire\n" : "\n";
  text += "[parameters]\n";
  for (const ShapeNumber& number : fit.numbers) {
    if (!number.determined) {
      text += fmt::format("# {}: not determined by these points\n", number.name);
      continue;
    }
    line(number.name, fmt::format("{{ value = {}, standard_error = {} }}", text_of(number.value),
                                  text_of(number.standard_error)));
  }
  text += "\n[fit]\n";
  line("points", std::to_string(fit.distance.size()));
  line("unknowns", std::to_string(fit.unknowns));
  line("rank", std::to_string(fit.rank));
  if (fit.intervals > 0) line("intervals", std::to_string(fit.intervals));
  line("residual_rms", text_of(fit.residual_rms));
  line(fit.chi_square ? "noise_over_sigma" : "noise", text_of(fit.noise));
  if (fit.chi_square) line("chi_square", text_of(*fit.chi_square));
  line("degrees_of_freedom", std::to_string(fit.degrees_of_freedom));
  if (!fit.left_out.empty()) line("left_out", std::to_string(fit.left_out.size()));
  if (fit.planar) line("planar", "true");
  if (!fit.misfit.empty()) line("misfit", quoted(fit.misfit));
  text += "\n[provenance]\n";
  line("points_file", quoted(origin.points_file));
  line("command_line", quoted(origin.command_line));
  line("program_version", quoted(std::string(version().program)));
  line("git_commit", quoted(std::string(version().git_commit)));
  return text;
}

void write_shape(const std::filesystem::path& file, const ShapeFit& fit,
                 const ShapeOrigin& origin) {
  const std::string text = shape_text(fit, origin);
  replace_file(file, {text.begin(), text.end()});
}

DarbouxTable read_shape(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string text = read_text(file, "a shape", largest_shape);
  const toml::table root = toml_table(text, name);
  const toml::array* k0 = root["shape"]["k0"].as_array();
  if (k0 == nullptr) {
    throw InvalidInput(name + ": has no `k0 = [[s, k1, k2, k3], ...]` in [shape]");
  }
  const std::string where = place(name, k0->source()) + ": ";
  const auto rows = darboux_rows(*k0);
  if (!rows) throw InvalidInput(where + "k0 must be rows [s, k1, k2, k3] of numbers");
  try {
    return DarbouxTable(*rows);
  } catch (const InvalidInput& error) {
    throw InvalidInput(where + error.what());
  }
}

}  // namespace wirepack
