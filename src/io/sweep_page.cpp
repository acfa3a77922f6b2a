#include "wirepack/io/sweep_page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/io/view_page.hpp"

#include "atomic_file.hpp"
#include "xml_text.hpp"

namespace wirepack {

namespace {

constexpr std::size_t most_points = 400;  // of a picture or a curve
constexpr double height = 90, curve_width = 160;
// Forces F R^2/YI that a curve spans.
constexpr double weakest = 0.01, strongest = 100;

constexpr std::string_view head =
    R"HTML(<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"/>
<meta name="viewport" content="width=device-width"/><title>Sweep</title><style>
body{font:15px sans-serif;max-width:80em;margin:2em auto;padding:0 1em}
table{border-collapse:collapse}
td,th{padding:.3em .8em;border-bottom:1px solid #ddd;text-align:right;vertical-align:middle}
td:first-child,th:first-child,td:last-child{text-align:left}svg{display:block}
a{display:inline-block;text-align:center;font-size:small}
svg *{fill:none;stroke:#1f77b4;stroke-width:1}svg .edge{stroke:#aaa}
.done{color:#1a7f37}.failed{color:#c00}.running{color:#1f77b4}</style></head><body>
)HTML";

/// Points of a drawing, of which a long list is thinned out; y goes up.
class Polyline {
 public:
  explicit Polyline(std::size_t count) : step_(1 + count / most_points) {}
  void add(double x, double y) {
    if (count_++ % step_ == 0) text_ += fmt::format("{:.1f},{:.1f} ", x, height - y);
  }
  std::string svg() const { return fmt::format("<polyline points=\"{}\"/>", text_); }

 private:
  std::size_t step_, count_ = 0;
  std::string text_;
};

std::string drawing(double width, const std::string& content) {
  return fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">{2}</svg>", width,
                     height, content);
}

std::string picture(const Hdf5Reader& reader, const Scenario& scenario) {
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) return "";
  const Points nodes = reader.frame(frames.back()).rod.nodes;
  const double middle = height / 2, scale = 0.95 * middle / scenario.cavity.radius;
  Polyline wire(static_cast<std::size_t>(nodes.cols()));
  for (Index i = 0; i < nodes.cols(); ++i) {
    wire.add(middle + scale * nodes(0, i), middle + scale * nodes(2, i));
  }
  const std::string edge = fmt::format(
      "<circle class=\"edge\" cx=\"{0}\" cy=\"{0}\" r=\"{1:.1f}\"/>", middle, 0.95 * middle);
  return drawing(height, edge + wire.svg());
}

std::string curve(const Hdf5Reader& reader, double largest_density) {
  const std::vector<HistoryRow> history = reader.history();
  Polyline line(history.size());
  for (const HistoryRow& row : history) {
    const double force = std::clamp(row.scaled_force, weakest, strongest);
    line.add(curve_width * row.packing_density / largest_density,
             height * std::log(force / weakest) / std::log(strongest / weakest));
  }
  const std::string frame =
      fmt::format("<rect class=\"edge\" width=\"{}\" height=\"{}\"/>", curve_width, height);
  return drawing(curve_width, frame + line.svg());
}

// A drawing that leads to the page of a run; without that, the drawing and the reason.
std::string linked(const std::string& drawing, const std::filesystem::path& folder,
                   const std::string& task) {
  const std::string page = task + "/view.html";
  try {
    update_view_page(folder / task / task_result_file, folder / page);
  } catch (const std::runtime_error& error) {  // of files, or a folder in the place of the page
    return drawing + "no page: " + xml_escaped(error.what());
  }
  return fmt::format("<a href=\"./{}\" aria-label=\"{}, page\">{}page</a>", xml_escaped(page),
                     xml_escaped(task), drawing);
}

// Both drawings as cells of a table; empty ones where there is nothing that can be read.
std::string drawings(const std::filesystem::path& folder, const SweepPageTask& task,
                     double largest_density) {
  const std::filesystem::path result = folder / task.name / task_result_file;
  try {
    if (std::filesystem::exists(result)) {
      const Hdf5Reader reader(result);
      const std::string wire = picture(reader, task.status.scenario);
      return fmt::format("<td>{}</td><td>{}</td>",
                         wire.empty() ? wire : linked(wire, folder, task.name),
                         curve(reader, largest_density));
    }
  } catch (const FileError&) {  // the state says that it is damaged
  }
  return "<td></td><td></td>";
}

}  // namespace

std::string shown_hours(double seconds) {
  return seconds < 0 ? "?" : fmt::format("{:.3f}", seconds / 3600);
}

std::filesystem::path write_sweep_page(const std::filesystem::path& folder,
                                       const std::string& summary,
                                       const std::vector<SweepPageTask>& tasks) {
  double largest_density = 1e-9;
  for (const SweepPageTask& task : tasks) {
    largest_density = std::max(largest_density, task.status.last.packing_density);
  }
  std::string text(head);
  text += fmt::format(
      "<h1>{}</h1><p>{}</p><table><tr><th>task</th><th>state</th><th>phi</th><th>increment</th>"
      "<th>hours</th><th>left</th><th>wire</th><th>F R<sup>2</sup>/YI, {} to {} (log), against "
      "phi, "
      "0 to {:.3f}</th><th></th></tr>\n",
      xml_escaped(folder.string()), xml_escaped(summary), weakest, strongest, largest_density);
  for (const SweepPageTask& task : tasks) {
    const TaskStatus& status = task.status;
    const HistoryRow& last = status.last;
    text += fmt::format(
        "<tr><td>{}</td><td "
        "class=\"{}\">{}</td><td>{:.4f}</td><td>{:.0f}</td><td>{}</td><td>{}</td>"
        "{}<td>{}</td></tr>\n",
        xml_escaped(task.name), name_of(status.state), name_of(status.state), last.packing_density,
        last.increment, shown_hours(last.wall_seconds), shown_hours(task.seconds_left),
        drawings(folder, task, largest_density),
        xml_escaped(status.remark.empty() ? status.stop_reason : status.remark));
  }
  text += "</table></body></html>\n";
  const std::filesystem::path page = folder / "status.html";
  replace_file(page, {text.begin(), text.end()});
  return page;
}

}  // namespace wirepack
