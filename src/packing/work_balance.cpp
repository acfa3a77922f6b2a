#include "wirepack/packing/work_balance.hpp"

#include <algorithm>
#include <cmath>

namespace wirepack {

namespace {

// An error below this share of an increment's work is ignored. The force counts as YI / R^2 at
// least.
constexpr double negligible_share = 0.02;
// Increments are not halved while all errors together are below this share of all work. Whole edges
// have a steady error besides, so less is allowed.
constexpr double error_share = 0.005;
constexpr double error_share_beside_edges = 0.003;
// The mesh may keep this share of the work over a whole edge; the weight of a new edge in its mean.
constexpr double largest_edge_share = 0.02;
constexpr double edge_weight = 1.0 / 8;
// The share of the scatter that each part of an edge makes forgotten.
constexpr double forgotten = 1.0 / 64;

// A split that takes more than this share of the work over an edge has set off a snap.
constexpr double largest_split_share = 0.1;

double allowed_error(const WorkBalance& balance, const WorkErrors& errors) {
  return balance.work * (errors.edge_share == 0 ? error_share : error_share_beside_edges);
}

// One snap says little about the edges after it, so the scatter doubles at most.
double scatter_after(double off, double scatter) {
  if (off > scatter) return std::min(off, 2 * scatter + negligible_share);
  return scatter + edge_weight * (off - scatter);
}

}  // namespace

WorkBooking book(const WorkStep& step, WorkBalance& balance, WorkErrors& errors) {
  const double work = step.fed * (step.force_before + step.force) / 2;
  const double uncertain = step.fed * std::abs(step.force - step.force_before) / 2;
  const double scale =
      step.fed * std::max({std::abs(step.force), std::abs(step.force_before), step.force_unit});
  balance.work += work;
  const double allowed = allowed_error(balance, errors);
  const double missing = work - step.spent;
  if (!step.whole_edge) errors.edge_scatter *= 1 - forgotten;
  if (!step.whole_edge && missing > uncertain + negligible_share * scale) {
    balance.released += missing;
    return {missing, uncertain <= std::max(allowed, negligible_share * scale)};
  }
  const double error = missing - (step.whole_edge ? errors.edge_share * scale : 0);
  const double before = std::abs(errors.trapezoid);
  errors.trapezoid += error;
  if (step.whole_edge) {
    const double share = std::clamp(missing / scale, -largest_edge_share, largest_edge_share);
    errors.edge_share += edge_weight * (share - errors.edge_share);
    errors.edge_scatter = scatter_after(std::abs(error) / scale, errors.edge_scatter);
  }
  const bool small = std::abs(error) <= negligible_share * scale;
  return {0, small || std::abs(errors.trapezoid) <= std::max(before, allowed)};
}

bool whole_edge_is_likely_resolved(double edge_length, double force, double force_unit,
                                   const WorkBalance& balance, const WorkErrors& errors) {
  if (errors.edge_scatter <= negligible_share) return true;
  const double expected = errors.edge_scatter * edge_length * std::max(std::abs(force), force_unit);
  return std::abs(errors.trapezoid) + expected <= allowed_error(balance, errors);
}

double book_split(double taken, double edge_work, WorkBalance& balance) {
  const bool snap = taken > largest_split_share * edge_work;
  (snap ? balance.released : balance.remeshing) += taken;
  return snap ? taken : 0;
}

}  // namespace wirepack
