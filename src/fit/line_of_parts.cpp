#include "line_of_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "chosen_points.hpp"
#include "index_lists.hpp"

namespace wirepack {

namespace {

constexpr double turns_of_step =
    fewest_turns_of_parts / 4;  // from the start of a part to that of the next
constexpr Index fewest_of_step = 12;
constexpr Index samples_of_step = 8;  // between two points

// Places in the list where a part begins, each a few turns behind the one before.
std::vector<Index> cuts_of(const Points& points) {
  std::vector<Index> cuts{0};
  double turned = 0;
  const Index last = points.cols() - 1;
  for (Index i = 1; i < last; ++i) {
    const Vec3 a = points.col(i) - points.col(i - 1), b = points.col(i + 1) - points.col(i);
    turned += std::atan2(a.cross(b).norm(), a.dot(b));
    if (turned < turns_of_step * 2 * pi || i - cuts.back() < fewest_of_step) continue;
    cuts.push_back(i);
    turned = 0;
  }
  if (last - cuts.back() < fewest_of_step && cuts.size() > 1) cuts.pop_back();
  cuts.push_back(last);
  return cuts;
}

struct Part {
  Index first;  // in the list
  DarbouxCurve curve;
  std::vector<double> feet;  // growing, as scatter along the wire is none of its length

  Vec3 at(Index step, double share) const {
    const auto i = static_cast<std::size_t>(step - first);
    return curve.at((1 - share) * feet[i] + share * feet[i + 1]).position;
  }
};

}  // namespace

std::optional<LineOfParts> line_of_parts(
    const MeasuredPoints& points,
    const std::function<CurveSolution(const MeasuredPoints&)>& curve_through) {
  const std::vector<Index> cuts = cuts_of(points.position);
  if (cuts.size() < 5) return std::nullopt;
  std::vector<Part> parts;
  for (std::size_t k = 0; k + 2 < cuts.size(); ++k) {
    const std::vector<Index> which = consecutive(cuts[k], cuts[k + 2] - cuts[k] + 1);
    const CurveSolution solution = curve_through(chosen(points, which));
    if (!solution.converged) return std::nullopt;
    Part part{cuts[k], solution.curve, {solution.feet.begin(), solution.feet.end()}};
    std::sort(part.feet.begin(), part.feet.end());
    parts.push_back(std::move(part));
  }
  std::vector<Vec3> samples{parts.front().at(0, 0)};
  std::vector<Index> sample_of{0};
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Part& one = parts[k > 0 ? k - 1 : 0];
    const Part& next = parts[std::min(k, parts.size() - 1)];
    for (Index step = cuts[k]; step < cuts[k + 1]; ++step) {
      for (Index j = 1; j <= samples_of_step; ++j) {
        const double share = static_cast<double>(j) / samples_of_step;
        const double part = (static_cast<double>(step - cuts[k]) + share) /
                            static_cast<double>(cuts[k + 1] - cuts[k]);
        const double smooth = part * part * (3 - 2 * part);
        const Vec3 sample = (1 - smooth) * one.at(step, share) + smooth * next.at(step, share);
        if ((sample - samples.back()).norm() > 1e-9) samples.push_back(sample);
      }
      sample_of.push_back(std::ssize(samples) - 1);
    }
  }
  StartLine line;
  line.samples.resize(3, std::ssize(samples));
  for (Index i = 0; i < line.samples.cols(); ++i) {
    line.samples.col(i) = samples[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd arcs = cumulated_chords(line.samples);
  line.place = arcs(sample_of) / arcs[arcs.size() - 1];
  line.intervals = points.count() / 3;
  return LineOfParts{std::move(line), turns_of_step * static_cast<double>(cuts.size() - 1)};
}

}  // namespace wirepack
