#include "wirepack/rod/turning_chart.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

Quat rotation_of(const Vec3& vector) {
  const double angle = vector.norm();
  return angle > 0 ? rotation_about(vector / angle, angle) : Quat::Identity();
}

// Transpose of the left Jacobian of the exponential map, applied: J_l(v)^T b, where
// exp(v + dv) = exp(J_l(v) dv) exp(v).
Vec3 jacobian_transposed(const Vec3& v, const Vec3& b) {
  const double angle2 = v.squaredNorm();
  double c1 = 0.5 - angle2 / 24;       // (1 - cos) / angle^2
  double c2 = 1.0 / 6 - angle2 / 120;  // (angle - sin) / angle^3
  if (angle2 > 1e-6) {
    const double angle = std::sqrt(angle2);
    c1 = (1 - std::cos(angle)) / angle2;
    c2 = (angle - std::sin(angle)) / (angle2 * angle);
  }
  return b - c1 * v.cross(b) + c2 * v.cross(v.cross(b));
}

double taper_weight(double arc, double taper) {
  const double u = std::min(1.0, arc / taper);
  return u * u * (3 - 2 * u);
}

}  // namespace

TurningChart::TurningChart(const FrameChart& chart, double taper)
    : chart_(&chart),
      start_(chart.unknowns()),
      turns_(taper > 0),
      moves_(Points::Zero(3, chart.reference().node_count())) {
  if (!turns_) return;
  const RodState& reference = chart.reference();
  const Index n = reference.node_count();
  node_weight_.setZero(n);
  frame_weight_.setZero(static_cast<Index>(reference.frames.size()));
  double arc = 0;
  for (Index j = reference.edge_count(); j-- > 0;) {
    const double length =
        (reference.nodes.col(next_node(reference, j)) - reference.nodes.col(j)).norm();
    frame_weight_[j] = taper_weight(arc + length / 2, taper);
    arc += length;
    node_weight_[j] = taper_weight(arc, taper);
  }
  Mat3 inertia = Mat3::Zero();
  for (Index i = 0; i < n; ++i) {
    const Vec3 r = reference.nodes.col(i);
    inertia += node_weight_[i] * node_weight_[i] *
               (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  // a short wire near the axis can hardly be told apart from its turned self
  const double floor = 1e-3 * inertia.trace() + 1e-12 * reference.nodes.squaredNorm();
  inverse_inertia_ = (inertia + floor * Mat3::Identity()).inverse();
  node_turn_.resize(static_cast<std::size_t>(n));
  frame_turn_.resize(reference.frames.size());
}

Vec3 TurningChart::slots(const Eigen::VectorXd& v, Index node) const {
  Vec3 result = Vec3::Zero();
  for (int c = 0; c < 3; ++c) {
    if (const Index u = chart_->unknown(node, c); u >= 0) result[c] = v[u];
  }
  return result;
}

void TurningChart::set_state(const Eigen::VectorXd& z, RodState& out) {
  const RodState& reference = chart_->reference();
  const Index n = reference.node_count();
  if (!turns_) {
    x_ = start_ + z;
    for (Index i = 0; i < n; ++i) moves_.col(i) = slots(z, i);
    chart_->set_state(x_, out);
    return;
  }
  Vec3 moment = Vec3::Zero();
  for (Index i = 0; i < n; ++i) {
    moment += node_weight_[i] * Vec3(reference.nodes.col(i)).cross(slots(z, i));
  }
  omega_ = inverse_inertia_ * moment;
  x_ = start_ + z;
  for (Index i = 0; i < n; ++i) {
    const Vec3 spin = node_weight_[i] * omega_;
    Quat& turn = node_turn_[static_cast<std::size_t>(i)];
    turn = node_weight_[i] == 1 && i > 0 && node_weight_[i - 1] == 1
               ? node_turn_[static_cast<std::size_t>(i - 1)]
               : rotation_of(spin);
    const Vec3 r = reference.nodes.col(i);
    moves_.col(i) = slots(z, i) - spin.cross(r);
    const Vec3 x = turn * (r + moves_.col(i));
    for (int c = 0; c < 3; ++c) {
      if (const Index u = chart_->unknown(i, c); u >= 0) x_[u] = x[c];
    }
  }
  for (Index j = 0; j < frame_weight_.size(); ++j) {
    const Vec3 spin = frame_weight_[j] * omega_;
    Quat& turn = frame_turn_[static_cast<std::size_t>(j)];
    turn = frame_weight_[j] == 1 && j > 0 && frame_weight_[j - 1] == 1
               ? frame_turn_[static_cast<std::size_t>(j - 1)]
               : rotation_of(spin);
    const Index u = chart_->unknown(chart_->angle_block(j), 3);
    if (u >= 0) x_[u] -= spin.dot(chart_->reference_tangent(j));
  }
  chart_->set_state(x_, out, frame_turn_);
}

void TurningChart::pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                             const Points& by_move, Eigen::VectorXd& by_x,
                             Eigen::VectorXd& by_z) const {
  const auto add_moves = [&](Index i, const Vec3& force) {
    for (int c = 0; c < 3; ++c) {
      if (const Index u = chart_->unknown(i, c); u >= 0) by_z[u] += force[c];
    }
  };
  if (!turns_) {
    chart_->pull_back(state, by_node, by_frame, by_x);
    by_z = by_x;
    for (Index i = 0; i < by_move.cols(); ++i) add_moves(i, by_move.col(i));
    return;
  }
  chart_->pull_back(state, by_node, by_frame, by_x, frame_turn_);
  by_z = by_x;
  const RodState& reference = chart_->reference();
  const Index n = reference.node_count();
  Vec3 by_omega = Vec3::Zero();
  for (Index i = 0; i < n; ++i) {
    const double w = node_weight_[i];
    const Vec3 force = slots(by_x, i);
    Vec3 back = node_turn_[static_cast<std::size_t>(i)].conjugate() * force;
    if (by_move.cols() > 0) back += by_move.col(i);
    const Vec3 r = reference.nodes.col(i);
    by_omega += w * (jacobian_transposed(w * omega_, Vec3(state.nodes.col(i)).cross(force)) -
                     r.cross(back));
    for (int c = 0; c < 3; ++c) {
      if (const Index u = chart_->unknown(i, c); u >= 0) by_z[u] = back[c];
    }
  }
  for (Index j = 0; j < reference.edge_count(); ++j) {
    const Index u = chart_->unknown(chart_->angle_block(j), 3);
    const double w = frame_weight_[j];
    if (u < 0 || w == 0) continue;
    // Turning the reference under a fixed tangent t spins the frame about t by
    // (t + t0').spin / (1 + t.t0'), t0' the turned reference tangent.
    const Vec3 t = third_axis(state.frames[static_cast<std::size_t>(j)]);
    const Vec3 t0 = chart_->reference_tangent(j);
    const Vec3 turned_t0 = frame_turn_[static_cast<std::size_t>(j)] * t0;
    by_omega += w * by_x[u] *
                (jacobian_transposed(w * omega_, (t + turned_t0) / (1 + t.dot(turned_t0))) - t0);
  }
  const Vec3 q = inverse_inertia_ * by_omega;
  for (Index i = 0; i < n; ++i) {
    add_moves(i, node_weight_[i] * q.cross(Vec3(reference.nodes.col(i))));
  }
}

}  // namespace wirepack
