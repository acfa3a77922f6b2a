#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wirepack/core/plain_text.hpp"

#include "analysis.hpp"

namespace wirepack {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t name_width = 28;

std::string cell(const Quantity& quantity, double value) {
  if (!std::isfinite(value)) return "-";
  return quantity.whole ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string with_error(const Sample& sample) {
  if (!std::isfinite(sample.mean)) return "-";
  if (!std::isfinite(sample.deviation)) return fmt::format("{:.5g}", sample.mean);
  return fmt::format("{:.5g} +- {:.2g}", sample.mean, sample.standard_error());
}

/// Rows of named cells, as many columns to a block as fit a wide line.
struct Rows {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> columns;

  std::string text() const {
    std::string result;
    std::size_t start = 0;
    while (start < columns.size()) {
      std::vector<std::size_t> widths;
      std::size_t total = name_width;
      while (start + widths.size() < columns.size()) {
        std::size_t width = 12;
        for (const std::string& text : columns[start + widths.size()]) {
          width = std::max(width, text.size());
        }
        total += width + 2;
        if (total > 140 && !widths.empty()) break;
        widths.push_back(width);
      }
      for (std::size_t row = 0; row < names.size(); ++row) {
        result += fmt::format("{:<{}}", names[row], name_width);
        for (std::size_t k = 0; k < widths.size(); ++k) {
          result += fmt::format("  {:>{}}", columns[start + k][row], widths[k]);
        }
        result += "\n";
      }
      result += "\n";
      start += widths.size();
    }
    return result;
  }
};

std::vector<std::string> quantity_names(const std::string& first) {
  std::vector<std::string> names{first};
  for (const Quantity& q : frame_quantities()) {
    names.push_back(q.unit.empty() ? std::string(q.name) : fmt::format("{} [{}]", q.name, q.unit));
  }
  return names;
}

std::string frames_text(const std::vector<AnalysedRun>& runs) {
  Rows rows{quantity_names("# run"), {}};
  rows.names.emplace_back("knot");
  for (const AnalysedRun& run : runs) {
    for (const ObservedFrame& frame : run.frames) {
      std::vector<std::string>& column = rows.columns.emplace_back();
      column.push_back(plain_text(run.name));
      for (const Quantity& q : frame_quantities()) column.push_back(cell(q, q.of(frame)));
      column.push_back(frame.knot.name.empty() ? "not in the table" : frame.knot.name);
    }
  }
  return rows.text();
}

std::string level_name(std::string_view scale, double level) {
  return fmt::format("{} {:.4g}", scale == "force" ? "F/(Y a^2) =" : "F R^2/YI =", level);
}

std::string levels_text(const std::vector<AnalysedRun>& runs) {
  std::string text =
      "# phi_max: packing density where the force first reaches a level;\n"
      "# 'first' in one row of the history, 'mean' over the last edge length fed\n";
  for (const AnalysedRun& run : runs) {
    text += fmt::format("# {}\n{:<{}}  {:>10}  {:>10}\n", plain_text(run.name), "# level",
                        name_width, "first", "mean");
    for (const LevelDensity& l : run.levels) {
      text += fmt::format("{:<{}}  {:>10.6f}  {:>10}\n", level_name(l.scale, l.level), name_width,
                          l.first, l.mean ? fmt::format("{:.6f}", *l.mean) : "-");
    }
  }
  return text;
}

std::string names_of(const Ensemble& ensemble, const std::vector<AnalysedRun>& runs) {
  std::string names;
  for (const std::size_t k : ensemble.runs)
    names += (names.empty() ? "" : ", ") + plain_text(runs[k].name);
  return names;
}

std::string ensemble_text(const Ensemble& ensemble, const std::vector<AnalysedRun>& runs) {
  std::string text = fmt::format("\n# mean +- standard error over {} seeds: {}\n",
                                 ensemble.runs.size(), names_of(ensemble, runs));
  Rows rows{quantity_names("# over seeds"), {}};
  for (std::size_t f = 0; f < ensemble.quantities.size(); ++f) {
    std::vector<std::string>& column = rows.columns.emplace_back();
    column.push_back(fmt::format("frame {}", f + 1));
    for (const Sample& s : ensemble.quantities[f]) column.push_back(with_error(s));
  }
  text += rows.text();
  text += fmt::format("{:<{}}  {:>20}  {:>20}\n", "# phi_max at", name_width, "first", "mean");
  for (const Ensemble::Level& l : ensemble.levels) {
    text += fmt::format("{:<{}}  {:>20}  {:>20}\n", level_name(l.scale, l.level), name_width,
                        with_error(l.first), with_error(l.mean));
  }
  return text;
}

const char* name_of(Setup setup) {
  return setup == Setup::low_torsion ? "low_torsion" : "high_torsion";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const ObservedFrame& frame, const AnalysedRun& run) {
  Json row{{"run", frame.run}};
  for (const Quantity& q : frame_quantities()) {
    const double value = q.of(frame);
    row[std::string(q.name)] = q.whole ? Json(static_cast<std::int64_t>(value)) : number(value);
  }
  row["knot"] = frame.knot.name;
  row["radial_density"] = nullptr;  // an ellipsoid has no spherical shells
  for (const ShellDensity& s : frame.density) {
    row["radial_density"].push_back(
        {{"inner", s.inner}, {"outer", s.outer}, {"density", s.density}});
  }
  for (const ShellOrder& s : frame.order) {
    row["order_by_shell"].push_back(
        {{"inner", s.inner}, {"outer", s.outer}, {"edges", s.edges}, {"order", s.order}});
  }
  row["contact_patches"] = Json::array();
  for (const ContactPatch& p : frame.contacts) {
    row["contact_patches"].push_back({{"force", p.force}, {"angle", p.angle}, {"pairs", p.pairs}});
  }
  row["phi_max"] = Json::array();
  for (const LevelDensity& l : run.levels) {
    row["phi_max"].push_back({{"scale", l.scale},
                              {"level", l.level},
                              {"first", l.first},
                              {"mean_over_edge", l.mean ? Json(*l.mean) : Json(nullptr)}});
  }
  return row;
}

Json json_of(const Sample& sample) {
  return {{"mean", number(sample.mean)},
          {"standard_error", number(sample.standard_error())},
          {"count", sample.count}};
}

Json json_of(const Ensemble& ensemble, const std::vector<AnalysedRun>& runs) {
  Json result{{"runs", Json::array()}, {"frames", Json::array()}, {"phi_max", Json::array()}};
  for (const std::size_t k : ensemble.runs) result["runs"].push_back(runs[k].name);
  for (const std::vector<Sample>& row : ensemble.quantities) {
    Json frame;
    for (std::size_t q = 0; q < row.size(); ++q) {
      frame[std::string(frame_quantities()[q].name)] = json_of(row[q]);
    }
    result["frames"].push_back(frame);
  }
  for (const Ensemble::Level& l : ensemble.levels) {
    result["phi_max"].push_back({{"scale", l.scale},
                                 {"level", l.level},
                                 {"first", json_of(l.first)},
                                 {"mean_over_edge", json_of(l.mean)}});
  }
  return result;
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string analysis_table(const std::vector<AnalysedRun>& runs) {
  std::string text = frames_text(runs) + levels_text(runs);
  for (const Ensemble& ensemble : ensembles(runs)) text += ensemble_text(ensemble, runs);
  const std::vector<DensityLaw> laws = density_laws(runs);
  if (!laws.empty())
    text += "\n# phi_max (mean over an edge) = factor (a/R)^exponent, errors by bootstrap\n";
  for (const DensityLaw& law : laws) {
    text += fmt::format(
        "{:<13} {}: exponent {:.4f} +- {:.4f}, factor {:.4f} +- {:.4f}, {} runs as {}\n",
        name_of(law.setup), level_name("scaled_force", law.level), law.law.exponent,
        law.law.exponent_error, law.law.factor, law.law.factor_error, law.runs,
        plain_text(law.first_run));
  }
  return text;
}

std::string analysis_json(const std::vector<AnalysedRun>& runs) {
  Json result{
      {"frames", Json::array()}, {"ensembles", Json::array()}, {"power_laws", Json::array()}};
  for (const AnalysedRun& run : runs) {
    for (const ObservedFrame& frame : run.frames) result["frames"].push_back(json_of(frame, run));
  }
  for (const Ensemble& e : ensembles(runs)) result["ensembles"].push_back(json_of(e, runs));
  for (const DensityLaw& law : density_laws(runs)) {
    result["power_laws"].push_back({{"setup", name_of(law.setup)},
                                    {"first_run", law.first_run},
                                    {"scaled_force", law.level},
                                    {"runs", law.runs},
                                    {"exponent", law.law.exponent},
                                    {"exponent_error", law.law.exponent_error},
                                    {"factor", law.law.factor},
                                    {"factor_error", law.law.factor_error}});
  }
  return result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string analysis_csv(const std::vector<AnalysedRun>& runs) {
  std::string text = "run";
  for (const Quantity& q : frame_quantities()) text += fmt::format(",{}", q.name);
  text += ",knot\n";
  for (const AnalysedRun& run : runs) {
    for (const ObservedFrame& frame : run.frames) {
      text += csv_text(run.name);
      for (const Quantity& q : frame_quantities()) {
        const double value = q.of(frame);
        text += std::isfinite(value) ? fmt::format(",{}", value) : ",";
      }
      text += fmt::format(",{}\n", csv_text(frame.knot.name));
    }
  }
  return text;
}

}  // namespace wirepack
