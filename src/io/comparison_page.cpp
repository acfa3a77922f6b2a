#include "wirepack/io/comparison_page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "wirepack/core/version.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"
#include "xml_text.hpp"

namespace wirepack {

namespace {

std::string_view name_of(Way way) { return ways[static_cast<std::size_t>(way)].second; }

std::string heading(const ComparedQuantity& q) {
  return q.unit.empty() ? q.name : fmt::format("{} [{}]", q.name, q.unit);
}

std::string shown(const std::optional<SeedMean>& value) {
  if (!value) return "-";
  if (value->seeds > 1) return fmt::format("{:.4g}+-{:.1g}", value->mean, value->error);
  return fmt::format("{:.4g}", value->mean);
}

std::string shown_difference(const ComparedQuantity& q, const std::optional<double>& difference) {
  if (!difference || !std::isfinite(*difference)) return "-";
  return q.relative ? fmt::format("{:+.1f} %", 100 * *difference)
                    : fmt::format("{:+.3f}", *difference);
}

bool any_value(const ComparedQuantity& q, Way way) {
  const auto& values = q.values[static_cast<std::size_t>(way)];
  return std::any_of(values.begin(), values.end(), [](const auto& v) { return v.has_value(); });
}

/// The rows of a quantity: name and cells.
struct TableLine {
  std::string name;
  std::vector<std::string> cells;
};
std::vector<TableLine> lines_of(const ComparedQuantity& q) {
  std::vector<TableLine> lines;
  for (const auto& [way, name] : ways) {
    if (!any_value(q, way)) continue;
    TableLine line{std::string(name), {}};
    for (const auto& value : q.values[static_cast<std::size_t>(way)]) {
      line.cells.push_back(shown(value));
    }
    lines.push_back(line);
  }
  TableLine difference{"dynamic - quasistatic", {}};
  for (const auto& d : q.differences()) difference.cells.push_back(shown_difference(q, d));
  lines.push_back(difference);
  if (!q.spool.empty()) {
    TableLine spool{"inverse spool", {}};
    for (const auto& v : q.spool) spool.cells.push_back(v ? fmt::format("{:.4g}", *v) : "-");
    lines.push_back(spool);
  }
  return lines;
}

std::string verdict(const ComparedQuantity& q) {
  const std::optional<double> difference = q.mean_difference();
  if (!difference) return q.name + ": not in both runs";
  const bool agrees = std::abs(*difference) <= q.tolerance;
  return fmt::format(
      "{}: {} on average, tolerance {}: {}", q.name, shown_difference(q, difference),
      q.relative ? fmt::format("{:.0f} %", 100 * q.tolerance) : fmt::format("{:.3g}", q.tolerance),
      agrees ? "agrees" : "DIFFERS");
}

std::optional<SeedMean> last_value(const ComparedQuantity& q, Way way) {
  const auto& values = q.values[static_cast<std::size_t>(way)];
  return values.empty() ? std::nullopt : values.back();
}

// Densities with the value of a row of each run of a way.
Curve curve_of(const ComparedRun& run, std::string label, int colour,
               double (*of)(const Scenario&, const HistoryRow&)) {
  Curve curve{std::move(label), {}, colour, Stroke::thin_line};
  for (const HistoryRow& row : run.history) {
    curve.points.push_back({row.packing_density, of(run.scenario, row)});
  }
  return curve;
}

double scaled_energy(const Scenario& s, double energy) {
  return energy / units_of(s).scaled_energy();
}

// The whole history where a quantity is a column of it.
double (*history_value(const std::string& name))(const Scenario&, const HistoryRow&) {
  if (name == "bend_energy") {
    return [](const Scenario& s, const HistoryRow& r) { return scaled_energy(s, r.energy_bend); };
  }
  if (name == "twist_energy") {
    return [](const Scenario& s, const HistoryRow& r) { return scaled_energy(s, r.energy_twist); };
  }
  if (name == "scaled_force") {
    return [](const Scenario&, const HistoryRow& r) { return r.scaled_force; };
  }
  return nullptr;
}

void draw_quantity(const std::filesystem::path& folder, const Comparison& comparison,
                   const std::vector<ComparedRun>& runs, const ComparedQuantity& q) {
  std::vector<Curve> curves;
  if (auto* const of = history_value(q.name)) {
    for (const ComparedRun& run : runs) {
      curves.push_back(curve_of(run, "", static_cast<int>(run.way) + 1, of));
    }
  }
  for (const auto& [way, name] : ways) {
    if (!any_value(q, way)) continue;
    Curve curve{std::string(name), {}, static_cast<int>(way) + 1, Stroke::marks};
    const auto& values = q.values[static_cast<std::size_t>(way)];
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i]) curve.points.push_back({comparison.densities[i], values[i]->mean});
    }
    curves.push_back(curve);
  }
  if (!q.spool.empty()) {
    Curve curve{"inverse spool (d = 2.81 a)", {}, 0, Stroke::dashed_line};
    for (std::size_t i = 0; i < q.spool.size(); ++i) {
      if (q.spool[i]) curve.points.push_back({comparison.densities[i], *q.spool[i]});
    }
    curves.push_back(curve);
  }
  draw_curves(folder, q.name, heading(q), curves);
}

std::string html_table(const Comparison& comparison, const ComparedQuantity& q) {
  std::string text = "<table><tr><th>phi</th>";
  for (const double phi : comparison.densities) text += fmt::format("<th>{:.3g}</th>", phi);
  text += "</tr>\n";
  for (const TableLine& line : lines_of(q)) {
    text += "<tr><td>" + xml_escaped(line.name) + "</td>";
    for (const std::string& cell : line.cells) text += "<td>" + xml_escaped(cell) + "</td>";
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string inline_figure(const std::filesystem::path& file) {
  const std::vector<char> bytes = read_bytes(file);
  const std::string svg(bytes.begin(), bytes.end());
  const std::size_t start = svg.find("<svg");
  return start == std::string::npos ? std::string() : svg.substr(start);
}

std::string links(const std::vector<RunPage>& pages) {
  if (pages.empty()) return "";
  std::string text;
  for (const RunPage& page : pages) {
    text += fmt::format("{}<a href=\"./{}\">{}</a>", text.empty() ? "" : ", ",
                        xml_escaped(page.file), xml_escaped(page.label));
  }
  return "<p>The runs to look at: " + text + "</p>\n";
}

void put(const std::filesystem::path& file, const std::string& text) {
  replace_file(output_file(file, {.inputs = {}, .force = true}), {text.begin(), text.end()});
}

}  // namespace

std::vector<std::string> findings(const Comparison& comparison) {
  std::vector<std::string> result;
  for (const ComparedQuantity& q : comparison.quantities) result.push_back(verdict(q));
  for (const ForceBudget& b : comparison.budgets) {
    result.push_back(fmt::format(
        "{}: mean force {:.3f} YI/R^2 from L = 4 R on; {:.3f} is stored, {:.3f} rubbed off, "
        "{:.3f} viscous, {:.3f} released in jumps: the force {} the change of energy per length",
        name_of(b.way), b.force, b.stored, b.friction, b.viscous, b.released,
        b.force >= b.stored ? "exceeds" : "is BELOW"));
  }
  for (const ComparedQuantity& q : comparison.quantities) {
    if (q.name != "axis_order") continue;
    std::string text =
        fmt::format("order of coil axes at phi = {:.3g}:", comparison.densities.back());
    for (const auto& [way, name] : ways) {
      if (const auto v = last_value(q, way)) text += fmt::format(" {} {:.2f},", name, v->mean);
    }
    text.pop_back();
    result.push_back(text);
  }
  for (const Cost& c : comparison.costs) {
    result.push_back(
        fmt::format("{}: {:.3g} evaluations of energy and gradient, {:.1f} s to phi = {:.3g}",
                    name_of(c.way), c.evaluations, c.seconds, comparison.largest_density));
  }
  return result;
}

std::string comparison_table(const Comparison& comparison) {
  std::string text = fmt::format("# common range to phi = {:.4g}; means over phi +- {:.3g}\n",
                                 comparison.largest_density, comparison.window);
  for (const ComparedQuantity& q : comparison.quantities) {
    text += fmt::format("#\n{:<24}", heading(q));
    for (const double phi : comparison.densities)
      text += fmt::format(" {:>13}", fmt::format("phi={:.3g}", phi));
    text += "\n";
    for (const TableLine& line : lines_of(q)) {
      text += fmt::format("{:<24}", line.name);
      for (const std::string& cell : line.cells) text += fmt::format(" {:>13}", cell);
      text += "\n";
    }
  }
  text += "#\n";
  for (const std::string& finding : findings(comparison)) text += "# " + finding + "\n";
  return text;
}

std::string comparison_json(const Comparison& comparison) {
  using Json = nlohmann::ordered_json;
  const auto number = [](const std::optional<double>& v) {
    return v && std::isfinite(*v) ? Json(*v) : Json(nullptr);
  };
  Json result;
  result["largest_density"] = comparison.largest_density;
  result["densities"] = comparison.densities;
  result["window"] = comparison.window;
  Json quantities = Json::object();
  for (const ComparedQuantity& q : comparison.quantities) {
    Json entry;
    entry["unit"] = q.unit;
    entry["tolerance"] = q.tolerance;
    entry["relative"] = q.relative;
    for (const auto& [way, name] : ways) {
      if (!any_value(q, way)) continue;
      Json values = Json::array();
      for (const auto& v : q.values[static_cast<std::size_t>(way)]) {
        values.push_back(v ? Json{{"mean", v->mean}, {"error", v->error}, {"seeds", v->seeds}}
                           : Json(nullptr));
      }
      entry[std::string(name)] = values;
    }
    if (!q.spool.empty()) {
      Json values = Json::array();
      for (const auto& v : q.spool) values.push_back(number(v));
      entry["inverse_spool"] = values;
    }
    Json differences = Json::array();
    for (const auto& d : q.differences()) differences.push_back(number(d));
    entry["difference"] = differences;
    const auto mean = q.mean_difference();
    entry["mean_difference"] = number(mean);
    entry["agrees"] = mean ? Json(std::abs(*mean) <= q.tolerance) : Json(nullptr);
    quantities[q.name] = entry;
  }
  result["quantities"] = quantities;
  Json budgets = Json::object();
  for (const ForceBudget& b : comparison.budgets) {
    budgets[std::string(name_of(b.way))] = {{"force", b.force},
                                            {"stored", b.stored},
                                            {"friction", b.friction},
                                            {"viscous", b.viscous},
                                            {"released", b.released}};
  }
  result["force_budget"] = budgets;
  Json costs = Json::object();
  for (const Cost& c : comparison.costs) {
    costs[std::string(name_of(c.way))] = {{"evaluations", c.evaluations}, {"seconds", c.seconds}};
  }
  result["cost"] = costs;
  result["findings"] = findings(comparison);
  return result.dump(2) + "\n";
}

std::vector<std::string> comparison_files() {
  std::vector<std::string> files =
      figure_files({"bend_energy", "twist_energy", "scaled_force", "axis_order", "strand_spacing",
                    "contacts_per_length", "max_overlap"});
  for (const char* name : {"comparison.json", "comparison.html"}) files.emplace_back(name);
  return files;
}

void write_comparison(const std::filesystem::path& folder, const ComparisonText& text,
                      const std::vector<ComparedRun>& runs, const Comparison& comparison) {
  const std::string title = xml_escaped(text.title);
  const Version build = version();
  std::string page =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
      "</title>\n<style>body{font-family:sans-serif;max-width:62em;margin:2em auto;padding:0 1em}"
      "table{border-collapse:collapse;margin:1em 0}td,th{padding:.15em .6em;text-align:right;"
      "border-bottom:1px solid #ddd}td:first-child,th:first-child{text-align:left}"
      "svg{width:100%;height:auto;max-width:44em}pre{background:#f5f5f5;padding:1em}</style></"
      "head>\n"
      "<body><h1>" +
      title + "</h1>\n<p>" +
      fmt::format(
          "One scenario, packed by minimization and in time, without and with friction. "
          "Common range to phi = {:.4g}; values are means over phi &plusmn; {:.3g}, which "
          "evens out the sawtooth of the growing inlet edge. wirepack {} ({}).",
          comparison.largest_density, comparison.window, build.program, build.git_commit) +
      "</p>\n<ul>\n";
  for (const std::string& finding : findings(comparison)) {
    page += "<li>" + xml_escaped(finding) + "</li>\n";
  }
  page += "</ul>\n" + links(text.pages);
  for (const ComparedQuantity& q : comparison.quantities) {
    draw_quantity(folder, comparison, runs, q);
    page += "<h2>" + xml_escaped(heading(q)) + "</h2>\n" + html_table(comparison, q) +
            inline_figure(folder / (q.name + ".svg"));
  }
  page += "<h2>Configuration</h2>\n<pre>" + xml_escaped(text.config) + "</pre>\n</body></html>\n";
  put(folder / "comparison.json", comparison_json(comparison));
  put(folder / "comparison.html", page);
}

}  // namespace wirepack
