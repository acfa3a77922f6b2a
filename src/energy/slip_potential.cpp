#include "wirepack/energy/slip_potential.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace wirepack {

namespace {

constexpr Index wall = -1;

// Sliding strands hand their contact on to neighbouring edges, this far at most in an increment.
constexpr Index reach = 2;

bool before_in_order(const EdgePair& a, const EdgePair& b) {
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

// Memory of the contact itself, or else of the nearest one of the same two strands.
const SlipMemory* recall(std::span<const SlipMemory> memory, const EdgePair& edges) {
  const SlipMemory* found = nullptr;
  Index nearest = 2 * reach + 1;
  const auto from =
      std::lower_bound(memory.begin(), memory.end(), edges.first - reach,
                       [](const SlipMemory& m, Index first) { return m.edges.first < first; });
  for (auto m = from; m != memory.end() && m->edges.first <= edges.first + reach; ++m) {
    if ((m->edges.second == wall) != (edges.second == wall)) continue;
    const Index aside = std::abs(m->edges.second - edges.second);
    const Index distance = std::abs(m->edges.first - edges.first) + aside;
    if (aside > reach || distance >= nearest) continue;
    nearest = distance;
    found = &*m;
  }
  return found;
}

// Number of nodes that rub on the wall: all but a last one that a clamp (the nozzle) holds.
Index rubbing_nodes(const RodState& state) {
  return state.ends.last_clamped ? state.node_count() - 1 : state.node_count();
}

Vec3 point_of(const RodState& state, Index edge, double s) {
  return (0.5 - s) * state.nodes.col(edge) + (0.5 + s) * state.nodes.col(next_node(state, edge));
}

// Share of the straight way after which the gap is zero; it shrinks from `first` to `second` < 0.
double way_to_touch(double first, double second) {
  return first > 0 ? first / (first - second) : 0.0;
}

// Puts one edge of `out` where it is after this share of the straight way from `before` to `now`.
void move_edge(Index edge, const RodState& before, const RodState& now, double way, RodState& out) {
  for (const Index i : {edge, next_node(now, edge)}) {
    out.nodes.col(i) = (1 - way) * before.nodes.col(i) + way * now.nodes.col(i);
  }
  const auto j = static_cast<std::size_t>(edge);
  out.frames[j] = before.frames[j].slerp(way, now.frames[j]);
}

}  // namespace

SlipPotential::SlipPotential(const RodParams& params, const Cavity& cavity,
                             const FrictionParams& friction)
    : params_(params), cavity_(cavity), friction_(friction) {}

void SlipPotential::start(const RodState& state, std::span<const SelfContact> touches,
                          const Eigen::VectorXd& wall_forces, std::span<const SlipMemory> memory) {
  contacts_.clear();
  if (friction_.model == FrictionModel::none || friction_.static_coefficient == 0) return;
  const double tolerance = friction_.slip_tolerance * params_.radius;
  const double slow = friction_.dynamic_coefficient / friction_.static_coefficient;
  const auto add = [&](const EdgePair& edges, double normal_force, const SurfaceSlip& touch,
                       const auto& anchor_with) {
    const SlipMemory* known = recall(memory, edges);
    const bool slides = known != nullptr && known->slid > tolerance;
    const double limit = slides ? slow * tolerance : tolerance;
    Vec3 spring = known != nullptr ? touch.tangential(known->spring) : Vec3::Zero();
    if (const double length = spring.norm(); length > limit) spring *= limit / length;
    const double stiffness = friction_.static_coefficient * normal_force / tolerance;
    contacts_.push_back({edges, anchor_with(spring), stiffness, limit,
                         limit + (known != nullptr ? known->slid : 0)});
  };
  for (Index i = 0; i < rubbing_nodes(state); ++i) {
    if (wall_forces[i] <= 0) continue;
    add({i, wall}, wall_forces[i], wall_slip(state, i, params_.radius, cavity_),
        [&](const Vec3& spring) { return wall_anchor(state, params_, cavity_, i, spring); });
  }
  for (const SelfContact& touch : touches) {
    const Index i = touch.edges.first, j = touch.edges.second;
    const LineContact& line = touch.line;
    add(touch.edges, touch.force, strand_slip(state, i, line.s, j, line.t, line.separation),
        [&](const Vec3& spring) {
          return strand_anchor(state, params_, i, line.s, j, line.t, line.separation, spring);
        });
  }
}

SlipPotential::Joined SlipPotential::join(const RodState& before, const RodState& now,
                                          std::span<const SelfContact> touches,
                                          const Eigen::VectorXd& wall_forces, double usual_slip) {
  if (friction_.model == FrictionModel::none || friction_.static_coefficient == 0) return {};
  const double tolerance = friction_.slip_tolerance * params_.radius;
  std::vector<EdgePair> held;
  for (const Contact& c : contacts_) held.push_back(c.edges);
  std::sort(held.begin(), held.end(), before_in_order);
  // on the wall the node itself counts, of two strands also their neighbouring edges
  const auto is_held = [&](const EdgePair& edges) {
    const Index near = edges.second == wall ? 0 : reach;
    const auto from =
        std::lower_bound(held.begin(), held.end(), edges.first - near,
                         [](const EdgePair& h, Index first) { return h.first < first; });
    const auto to = std::find_if(from, held.end(),
                                 [&](const EdgePair& h) { return h.first > edges.first + near; });
    return std::any_of(from, to, [&](const EdgePair& h) {
      return (h.second == wall) == (edges.second == wall) &&
             std::abs(h.second - edges.second) <= near;
    });
  };
  std::vector<Contact> joining;
  Joined joined;
  // `anchor_at` puts an anchor where the wire is after a share of the straight way to `now`.
  const auto add = [&](const EdgePair& edges, double normal_force, double way,
                       const auto& anchor_at) {
    const double stiffness = friction_.static_coefficient * normal_force / tolerance;
    SurfaceAnchor anchor = anchor_at(0.0);
    const bool missed = anchor.slip(now, params_).u.norm() > usual_slip;
    if (!missed && way > 0) anchor = anchor_at(way);
    joined.missed |= missed;
    joining.push_back(
        {edges, anchor, stiffness, tolerance, tolerance + anchor.slip(now, params_).u.norm()});
  };
  RodState touch_state = before;
  touch_state.inlet_rest_length = now.inlet_rest_length;
  for (Index i = 0; i < rubbing_nodes(now); ++i) {
    if (wall_forces[i] <= 0 || is_held({i, wall})) continue;
    const double way = way_to_touch(wall_gap(cavity_, before.nodes.col(i), params_.radius),
                                    wall_gap(cavity_, now.nodes.col(i), params_.radius));
    add({i, wall}, wall_forces[i], way, [&](double share) {
      if (i > 0) move_edge(i - 1, before, now, share, touch_state);
      if (i < now.edge_count()) move_edge(i, before, now, share, touch_state);
      return wall_anchor(touch_state, params_, cavity_, i, Vec3::Zero());
    });
  }
  for (const SelfContact& touch : touches) {
    const auto& [i, j] = touch.edges;
    if (is_held(touch.edges)) continue;
    const double s = touch.line.s, t = touch.line.t;
    const double gap = (point_of(before, i, s) - point_of(before, j, t)).norm();
    const double way = way_to_touch(gap - 2 * params_.radius, -touch.overlap);
    add(touch.edges, touch.force, way, [&, i = i, j = j](double share) {
      move_edge(i, before, now, share, touch_state);
      move_edge(j, before, now, share, touch_state);
      const Vec3 separation = point_of(touch_state, i, s) - point_of(touch_state, j, t);
      return strand_anchor(touch_state, params_, i, s, j, t, separation, Vec3::Zero());
    });
  }
  contacts_.insert(contacts_.end(), joining.begin(), joining.end());
  joined.count = static_cast<Index>(joining.size());
  return joined;
}

void SlipPotential::hold_joined(Index count) {
  for (Contact& c : std::span(contacts_).last(static_cast<std::size_t>(count))) {
    c.stiffness = params_.youngs_modulus * params_.radius;
    c.limit = HUGE_VAL;
    c.expected = 0;
  }
}

void SlipPotential::release_joined(Index count, std::span<const SelfContact> touches,
                                   const Eigen::VectorXd& wall_forces) {
  const double tolerance = friction_.slip_tolerance * params_.radius;
  for (Contact& c : std::span(contacts_).last(static_cast<std::size_t>(count))) {
    double normal_force = 0;
    if (c.edges.second == wall) {
      normal_force = wall_forces[c.edges.first];
    } else {
      const auto found = std::lower_bound(touches.begin(), touches.end(), c.edges,
                                          [](const SelfContact& t, const EdgePair& edges) {
                                            return before_in_order(t.edges, edges);
                                          });
      if (found != touches.end() && !before_in_order(c.edges, found->edges)) {
        normal_force = found->force;
      }
    }
    c.stiffness = friction_.static_coefficient * normal_force / tolerance;
    c.limit = tolerance;
    c.expected = tolerance;
  }
}

Energy SlipPotential::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  for (const Contact& c : contacts_) {
    const SurfaceAnchor::Slip slip = c.anchor.slip(state, params_);
    const double length = slip.u.norm();
    double factor = c.stiffness;
    if (length <= c.limit) {
      energy.add(factor / 2 * length * length);
    } else {
      energy.add(factor * c.limit * (length - c.limit / 2));
      factor *= c.limit / length;
    }
    const Vec3 force = factor * slip.u;
    slip.map.add_force(force, gradient.node, gradient.frame);
    gradient.inlet_length += force.dot(slip.by_inlet_length);
  }
  return energy.total();
}

void SlipPotential::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (const Contact& c : contacts_) {
    const SurfaceAnchor::Slip slip = c.anchor.slip(state, params_);
    // k f'(v) / v: the parabola that touches f at v and lies above it elsewhere; v is the slip, or
    // the expected slip if that is larger
    const double length = std::max({slip.u.norm(), c.expected, c.limit});
    const double weight = length == c.limit ? c.stiffness : c.stiffness * c.limit / length;
    const Vec3 along = slip.map.normal.unitOrthogonal();
    for (const Vec3& direction : {along, Vec3(slip.map.normal.cross(along))}) {
      std::array<CurvatureModel::NodePart, 4> nodes;
      std::array<CurvatureModel::FramePart, 2> frames;
      for (std::size_t k = 0; k < 4; ++k) {
        const SurfaceSlip::NodePart& part = slip.map.nodes[k];
        nodes[k] = {part.node, part.weight * direction};
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const SurfaceSlip::EdgePart& part = slip.map.edges[k];
        frames[k] = {part.edge, part.lever.cross(direction)};
      }
      const std::size_t used = c.anchor.on_wall ? 1 : 4;
      model.add_square(weight, std::span(nodes).first(used), frames);
    }
  }
}

SlipWork SlipPotential::work(const RodState& state) const {
  SlipWork work;
  for (const Contact& c : contacts_) {
    const double length = c.anchor.slip(state, params_).u.norm();
    const double spring = std::min(length, c.limit);
    work.stored += c.stiffness / 2 * spring * spring;
    work.dissipated += c.stiffness * c.limit * (length - spring);
  }
  return work;
}

std::vector<SlipMemory> SlipPotential::memory(const RodState& state) const {
  std::vector<SlipMemory> memory;
  for (const Contact& c : contacts_) {
    const Vec3 u = c.anchor.slip(state, params_).u;
    const double length = u.norm();
    const double slid = std::max(0.0, length - c.limit);
    memory.push_back({c.edges, slid > 0 ? Vec3(c.limit / length * u) : u, slid});
  }
  std::sort(memory.begin(), memory.end(), [](const SlipMemory& a, const SlipMemory& b) {
    return before_in_order(a.edges, b.edges);
  });
  return memory;
}

}  // namespace wirepack
