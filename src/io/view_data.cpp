#include "view_data.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wirepack/core/error.hpp"
#include "wirepack/core/version.hpp"
#include "wirepack/io/hdf5_reader.hpp"

#include "coded_field.hpp"
#include "compressed_text.hpp"
#include "frame_spread.hpp"
#include "node_fields.hpp"
#include "packed_numbers.hpp"
#include "setup_name.hpp"

namespace wirepack {

namespace {

using Json = nlohmann::ordered_json;

// A smooth wire is nearly a polynomial from node to node.
constexpr int position_differences = 3;

/// A column of the history as the page shows it.
struct ViewColumn {
  const char *name, *label, *unit;
  double (*of)(const Scenario&, const HistoryRow&);
};

double scaled_energy(const Scenario& s, double energy) {
  return energy * s.cavity.radius / stiffness(s.wire).bend;
}

constexpr ViewColumn columns[] = {
    {"increment", "increment", "",
     [](const Scenario&, const HistoryRow& r) { return r.increment; }},
    {"density", "packing density φ", "",
     [](const Scenario&, const HistoryRow& r) { return r.packing_density; }},
    {"length", "inserted length L", "a",
     [](const Scenario& s, const HistoryRow& r) { return r.inserted_length / s.wire.radius; }},
    {"force", "injection force F", "YI/R²",
     [](const Scenario&, const HistoryRow& r) { return r.scaled_force; }},
    {"bend", "bending energy", "YI/R",
     [](const Scenario& s, const HistoryRow& r) { return scaled_energy(s, r.energy_bend); }},
    {"twist", "torsion energy", "YI/R",
     [](const Scenario& s, const HistoryRow& r) { return scaled_energy(s, r.energy_twist); }},
    {"snap", "released in a snap", "YI/R",
     [](const Scenario& s, const HistoryRow& r) { return scaled_energy(s, r.snap_energy); }},
    {"contacts", "contacts", "", [](const Scenario&, const HistoryRow& r) { return r.contacts; }},
    {"overlap", "largest overlap", "a",
     [](const Scenario& s, const HistoryRow& r) { return r.max_overlap / s.wire.radius; }},
    {"residual", "residual", "YI/R²",
     [](const Scenario&, const HistoryRow& r) { return r.residual; }},
};

/// Coordinates over `quantum`, rounded: all x, all y, all z.
std::vector<std::int16_t> rounded(const Points& nodes, double quantum) {
  std::vector<std::int16_t> numbers;
  numbers.reserve(static_cast<std::size_t>(nodes.size()));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double x : nodes.row(axis)) {
      numbers.push_back(static_cast<std::int16_t>(std::round(x / quantum)));
    }
  }
  return numbers;
}

Json frame_json(const Scenario& scenario, const PackingFrame& frame) {
  const double farthest = frame.rod.nodes.cwiseAbs().maxCoeff();
  if (!std::isfinite(farthest)) throw FileError("a frame has positions that are no numbers");
  const double quantum = std::max(farthest, semi_axes_of(scenario.cavity).maxCoeff()) / 32767;
  Json json;
  json["increment"] = frame.increment;
  json["nodes"] = frame.rod.node_count();
  json["quantum"] = quantum;
  json["position"] =
      compressed_text(packed_differences(rounded(frame.rod.nodes, quantum), position_differences));
  return json;
}

/// Frames with their positions, and the fields over all frames.
void add_frames(Json& json, const Hdf5Reader& reader, const Scenario& scenario,
                const std::vector<std::int64_t>& increments) {
  std::array<std::vector<Eigen::VectorXd>, node_fields.size()> values;
  Json frames = Json::array();
  for (const std::int64_t increment : increments) {
    const PackingFrame frame = reader.frame(increment);
    frames.push_back(frame_json(scenario, frame));
    for (std::size_t k = 0; k < node_fields.size(); ++k) {
      values[k].push_back(node_fields[k].of(scenario, frame));
    }
  }
  Json fields = Json::array();
  for (std::size_t k = 0; k < node_fields.size(); ++k) {
    const NodeField& field = node_fields[k];
    const ByteScale scale = byte_scale(values[k], field.logarithmic);
    Json codes = Json::array();
    for (const Eigen::VectorXd& list : values[k]) {
      codes.push_back(compressed_text(byte_differences(bytes_of(list, scale))));
    }
    fields.push_back({{"name", field.name},
                      {"label", field.label},
                      {"unit", field.unit},
                      {"logarithmic", field.logarithmic},
                      {"low", scale.low},
                      {"high", scale.high},
                      {"shown", {scale.shown_low, scale.shown_high}},
                      {"codes", codes}});
  }
  json["frames"] = frames;
  json["fields"] = fields;
}

Json history_json(const Scenario& scenario, const std::vector<HistoryRow>& history) {
  Json json = Json::array();
  for (const ViewColumn& column : columns) {
    std::vector<float> values;
    values.reserve(history.size());
    for (const HistoryRow& row : history) {
      values.push_back(static_cast<float>(column.of(scenario, row)));
    }
    json.push_back({{"name", column.name},
                    {"label", column.label},
                    {"unit", column.unit},
                    {"values", compressed_text(packed(values))}});
  }
  return json;
}

std::string balance_text(const WorkBalance& balance, const HistoryRow& last) {
  if (balance.work == 0) return "no work yet";
  const auto percent = [&](double part) { return 100 * part / balance.work; };
  return fmt::format(
      "work 100 % = energy {:.3g} % + released in snaps {:.3g} % + remeshing {:.3g} % + friction "
      "{:.3g} % + sticking contacts {:.3g} % + viscous {:.3g} % + motion {:.3g} % + residue {:.3g} "
      "%",
      percent(last.energy_total), percent(balance.released), percent(balance.remeshing),
      percent(balance.friction), percent(balance.contact_springs), percent(balance.viscous),
      percent(last.energy_kinetic), percent(residue(balance, last)));
}

Json provenance_json(const Hdf5Reader& reader, const Scenario& scenario,
                     const std::vector<HistoryRow>& history) {
  const PackingProgress progress = reader.progress();
  double worst = 0;
  for (const HistoryRow& row : history) worst = std::max(worst, row.residual);
  const std::string stop = reader.stop_reason();
  Json json = Json::array();
  const auto add = [&json](const char* label, const std::string& text) {
    json.push_back({label, text});
  };
  add("state", reader.finished() ? "finished: " + stop : "not finished");
  add("wirepack", reader.program_version());
  add("commit", reader.git_commit());
  add("libraries", reader.library_versions());
  add("seed", fmt::format("{}", scenario.seed));
  add("command", reader.command_line());
  add("largest residual", fmt::format("{:.3g} YI/R²", worst));
  add("balance of work", balance_text(progress.balance, progress.last));
  add("snaps", fmt::format("{}", progress.snaps));
  add("page made by",
      fmt::format("wirepack {}, commit {}", version().program, version().git_commit));
  return json;
}

}  // namespace

std::string view_data(const std::filesystem::path& result, std::size_t most_frames) {
  const Hdf5Reader reader(result);
  const Scenario scenario = reader.scenario();
  const std::vector<std::int64_t> frames = reader.frame_increments();
  const std::vector<HistoryRow> history = reader.history();
  if (frames.empty() || history.empty()) {
    throw FileError(result.string() + ": holds no frame yet");
  }
  Json json;
  json["name"] = result.filename().string();
  json["setup"] = setup_name(scenario.setup);
  json["method"] = scenario.method == Method::dynamic ? "in time" : "quasi-static";
  json["wire_radius"] = scenario.wire.radius;
  json["cavity_radius"] = scenario.cavity.radius;
  const Vec3 semi_axes = semi_axes_of(scenario.cavity);
  json["semi_axes"] = {semi_axes.x(), semi_axes.y(), semi_axes.z()};
  json["saved_frames"] = frames.size();
  json["position_differences"] = position_differences;
  add_frames(json, reader, scenario, spread(frames, most_frames));
  json["rows"] = history.size();
  json["longest"] = history.back().inserted_length / scenario.wire.radius;
  json["history"] = history_json(scenario, history);
  json["provenance"] = provenance_json(reader, scenario, history);
  json["config"] = reader.config();
  const std::string text =
      json.dump(-1, ' ', false, Json::error_handler_t::replace);  // file names may be any bytes
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace wirepack
