#include "wirepack/packing/mean_force.hpp"

#include <algorithm>

namespace wirepack {

namespace {

constexpr double round_off = 1e-9;

}  // namespace

void note_force(double fed, const HistoryRow& row, std::vector<ForceReading>& recent) {
  recent.push_back({row.inserted_length, row.force});
  const double start = row.inserted_length - fed * (1 - round_off);
  const auto needed = std::find_if(recent.begin(), recent.end(), [&](const ForceReading& r) {
    return r.inserted_length > start;
  });
  // and the last one before
  if (needed != recent.begin()) recent.erase(recent.begin(), needed - 1);
}

std::optional<double> mean_force(double fed, std::span<const ForceReading> recent) {
  if (recent.empty()) return std::nullopt;
  const double end = recent.back().inserted_length, start = end - fed;
  if (recent.front().inserted_length > start + round_off * fed) return std::nullopt;
  if (recent.size() == 2) return recent.back().force;  // a whole edge lies between them
  double sum = 0;
  for (std::size_t k = 1; k < recent.size(); ++k) {
    const ForceReading& from = recent[k - 1];
    const ForceReading& to = recent[k];
    const double length = to.inserted_length - from.inserted_length;
    // the first part may reach back beyond the start
    const double part = std::clamp((to.inserted_length - start) / length, 0.0, 1.0);
    const double at_start = to.force + part * (from.force - to.force);
    sum += part * length * (at_start + to.force) / 2;
  }
  return sum / fed;
}

std::vector<MeanForce> mean_forces(const Scenario& scenario, const std::vector<HistoryRow>& history,
                                   double fed) {
  fed = std::max(fed, scenario.wire.edge_length);
  std::vector<MeanForce> means;
  std::vector<ForceReading> recent;
  for (const HistoryRow& row : history) {
    if (row.inserted_length <= first_coil_length(scenario.cavity)) continue;
    note_force(fed, row, recent);
    const std::optional<double> mean = mean_force(fed, recent);
    if (mean) means.push_back({row.packing_density, *mean});
  }
  return means;
}

std::optional<double> density_at_force(const std::vector<MeanForce>& means, double force) {
  const auto reached = std::find_if(means.begin(), means.end(),
                                    [&](const MeanForce& mean) { return mean.force >= force; });
  if (reached == means.begin() || reached == means.end()) return std::nullopt;
  return reached->packing_density;
}

}  // namespace wirepack
