#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/observe/coil_report.hpp"
#include "wirepack/packing/imperfection.hpp"

#include "command.hpp"

namespace wirepack {

namespace {

struct Options {
  std::vector<std::string> results;
  std::vector<double> densities;
  bool json = false;
};

/// One frame of one run.
struct Observed {
  std::string run;
  Scenario scenario;
  PackingFrame frame;
  HistoryRow row;
  CoilReport coils;
};

/// A column of the table.
struct Quantity {
  std::string_view name, unit;
  double (*of)(const Observed&);
  bool whole = false;
};

double energy_unit(const Scenario& s) { return units_of(s).scaled_energy(); }

constexpr std::array<Quantity, 13> quantities{{
    {"increment", "", [](const Observed& o) { return o.frame.increment; }, true},
    {"inserted_length", "length", [](const Observed& o) { return o.frame.inserted_length; }},
    {"packing_density", "", [](const Observed& o) { return o.frame.packing_density; }},
    {"bend_energy", "YI/R",
     [](const Observed& o) { return o.row.energy_bend / energy_unit(o.scenario); }},
    {"twist_energy", "YI/R",
     [](const Observed& o) { return o.row.energy_twist / energy_unit(o.scenario); }},
    {"scaled_force", "YI/R^2", [](const Observed& o) { return o.row.scaled_force; }},
    {"axis_order", "", [](const Observed& o) { return o.coils.axis_order; }},
    {"feed_alignment", "", [](const Observed& o) { return o.coils.feed_alignment; }},
    {"reversals", "", [](const Observed& o) { return static_cast<double>(o.coils.reversals); },
     true},
    {"twist", "turns", [](const Observed& o) { return o.coils.twist; }},
    {"writhe", "", [](const Observed& o) { return o.coils.writhe; }},
    {"tip_rotation", "turns", [](const Observed& o) { return o.coils.tip_rotation(); }},
    {"contacts", "", [](const Observed& o) { return o.row.contacts; }, true},
}};

Observed observed(const std::string& run, const Hdf5Reader& reader,
                  const std::vector<HistoryRow>& history, std::int64_t increment) {
  Observed o{run, reader.scenario(), reader.frame(increment), {}, {}};
  for (const HistoryRow& row : history) {
    if (row.increment == o.frame.increment) o.row = row;
  }
  o.frame.rod.twist_guide.assign(static_cast<std::size_t>(o.frame.rod.node_count()), 0.0);
  o.coils = coil_report(o.frame.rod, drawn_setup(o.scenario).nozzle.direction);
  return o;
}

/// The last frame, or those nearest to the densities that the run has reached.
std::vector<Observed> observe_run(const std::string& file, const std::vector<double>& densities) {
  const Hdf5Reader reader(file);
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) throw FileError(file + ": holds no frame yet");
  const std::vector<HistoryRow> history = reader.history();
  std::vector<Observed> result;
  if (densities.empty()) result.push_back(observed(file, reader, history, frames.back()));
  const auto density_at = [&](std::int64_t increment) {
    for (const HistoryRow& row : history) {
      if (row.increment == static_cast<double>(increment)) return row.packing_density;
    }
    return 0.0;
  };
  for (const double density : densities) {
    std::int64_t nearest = frames.front();
    for (const std::int64_t frame : frames) {
      if (std::abs(density_at(frame) - density) < std::abs(density_at(nearest) - density)) {
        nearest = frame;
      }
    }
    const double spacing = reader.scenario().output.frame_every_density;
    if (std::abs(density_at(nearest) - density) > spacing) continue;  // not reached
    result.push_back(observed(file, reader, history, nearest));
  }
  return result;
}

std::string shown(const Quantity& quantity, double value) {
  return quantity.whole ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value);
}

std::string table(const std::vector<Observed>& rows) {
  std::size_t width = 3;
  for (const Observed& row : rows) width = std::max(width, row.run.size());
  std::string text = fmt::format("#{:<{}}", "run", width);
  std::string units = fmt::format("#{:<{}}", "", width);
  const auto column = [](std::string_view name) { return std::max<std::size_t>(name.size(), 8); };
  for (const Quantity& q : quantities) {
    text += fmt::format("  {:>{}}", q.name, column(q.name));
    units +=
        fmt::format("  {:>{}}", q.unit.empty() ? "" : fmt::format("[{}]", q.unit), column(q.name));
  }
  text += "\n" + units + "\n";
  for (const Observed& row : rows) {
    text += fmt::format(" {:<{}}", row.run, width);
    for (const Quantity& q : quantities) {
      text += fmt::format("  {:>{}}", shown(q, q.of(row)), column(q.name));
    }
    text += "\n";
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string json(const std::vector<Observed>& rows) {
  std::string text = "[";
  for (const Observed& row : rows) {
    text += (text.size() > 1 ? ",\n {" : "\n {") + fmt::format("\"run\": {}", quoted(row.run));
    for (const Quantity& q : quantities) {
      text += fmt::format(", \"{}\": {}", q.name,
                          q.whole ? shown(q, q.of(row)) : fmt::format("{:.17g}", q.of(row)));
    }
    text += "}";
  }
  return text + "\n]\n";
}

int analyze(const Options& options) {
  std::vector<Observed> rows;
  for (const std::string& result : results_named(options.results)) {
    std::vector<Observed> of_run = observe_run(result, options.densities);
    std::move(of_run.begin(), of_run.end(), std::back_inserter(rows));
  }
  fmt::print("{}", options.json ? json(rows) : table(rows));
  return exit_done;
}

}  // namespace

Command analyze_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "analyze", "Energies, force, order of the coils, twist and writhe of saved frames");
  app->set_help_flag("--help,-h", "This help");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->results, "Results of wirepack run, or folders of sweeps")
      ->required();
  app->add_option("--density", options->densities,
                  "The frames nearest to these packing densities, where a run has reached them, "
                  "instead of the last one")
      ->type_name("PHI[,PHI]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0.0, 1.0));
  app->add_flag("--json", options->json, "For machines, with all digits");
  app->footer(
      "Order and alignment are of the axes of loops: 1 for a spool, around the feed axis; 0 for\n"
      "disorder. Reversals: changes of the sense in which the loops run around their common axis.\n"
      "Examples: wirepack analyze quickstart.h5\n"
      "          wirepack analyze low.h5 high.h5 --density 0.1,0.2,0.3 --json");
  return {app, [options] { return analyze(*options); }};
}

}  // namespace wirepack
