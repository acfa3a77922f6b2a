#include "wirepack/rod/turning_chart.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/lanes.hpp"
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

template <class T>
[[gnu::always_inline]] inline Triple<T> times(const Mat3& m, const Triple<T>& v) {
  return {m(0, 0) * v.x + m(0, 1) * v.y + m(0, 2) * v.z,
          m(1, 0) * v.x + m(1, 1) * v.y + m(1, 2) * v.z,
          m(2, 0) * v.x + m(2, 1) * v.y + m(2, 2) * v.z};
}

Mat3 hat(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// A sum of vectors and of lanes of vectors.
struct TripleSum {
  LaneSum x, y, z;

  template <class T>
  void add(const Triple<T>& v) {
    x.add(v.x);
    y.add(v.y);
    z.add(v.z);
  }
  Vec3 total() const { return {x.total(), y.total(), z.total()}; }
};

// Sum of a_i x b_i over the first columns.
Vec3 sum_of_crosses(const Points& a, const Points& b, Index count) {
  TripleSum sum;
  for_each_in_lanes(0, count, [&]<class T>(Index i) {
    sum.add(cross(load_columns<T>(a, i), load_columns<T>(b, i)));
  });
  return sum.total();
}

}  // namespace

TurningChart::TurningChart(const FrameChart& chart, double taper)
    : chart_(&chart), turns_(taper > 0) {
  const RodState& reference = chart.reference();
  const Index n = reference.node_count();
  step_.setZero(3, n);
  moves_.setZero(3, n);
  force_.setZero(3, n);
  if (!turns_) return;
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
  while (rigid_nodes_ < n && node_weight_[rigid_nodes_] == 1) ++rigid_nodes_;
  if (chart.frames_follow()) {
    turned_frames_.resize(reference.frames.size());
    turned_tangents_.resize(3, frame_weight_.size());
    while (rigid_frames_ < frame_weight_.size() && frame_weight_[rigid_frames_] == 1) {
      ++rigid_frames_;
    }
  }
  weighted_ = reference.nodes * node_weight_.asDiagonal();
  Mat3 inertia = Mat3::Zero();
  for (Index i = 0; i < n; ++i) {
    const Vec3 r = weighted_.col(i);
    inertia += r.squaredNorm() * Mat3::Identity() - r * r.transpose();
  }
  // a short wire near the axis can hardly be told apart from its turned self
  const double floor = 1e-3 * inertia.trace() + 1e-12 * reference.nodes.squaredNorm();
  inverse_inertia_ = (inertia + floor * Mat3::Identity()).inverse();
  back_.setZero(3, n);
  node_turn_.resize(static_cast<std::size_t>(n - rigid_nodes_));
}

void TurningChart::set_state(const Eigen::VectorXd& z, RodState& out) {
  const RodState& reference = chart_->reference();
  const Index n = reference.node_count();
  chart_->scatter(z, step_);
  if (chart_->frames_follow()) chart_->scatter_angles(z, angle_);
  if (!turns_) {
    moves_ = step_;
    out.nodes = reference.nodes + step_;
    if (chart_->frames_follow()) chart_->set_frames(chart_->start(), angle_, out);
    return;
  }
  omega_ = inverse_inertia_ * sum_of_crosses(weighted_, step_, n);
  const Mat3 spin = hat(omega_);
  const Quat whole_turn = rotation_of(omega_);
  turn_ = whole_turn.toRotationMatrix();
  for_each_in_lanes(0, n, [&]<class T>(Index i) {
    store_columns(load_columns<T>(step_, i) - times(spin, load_columns<T>(weighted_, i)), moves_,
                  i);
  });
  for_each_in_lanes(0, rigid_nodes_, [&]<class T>(Index i) {
    const Triple<T> moved = load_columns<T>(reference.nodes, i) + load_columns<T>(moves_, i);
    store_columns(times(turn_, moved), out.nodes, i);
  });
  for (Index i = rigid_nodes_; i < n; ++i) {
    Mat3& turn = node_turn_[static_cast<std::size_t>(i - rigid_nodes_)];
    turn = rotation_of(node_weight_[i] * omega_).toRotationMatrix();
    out.nodes.col(i) = turn * (reference.nodes.col(i) + moves_.col(i));
  }
  chart_->restore_held(out.nodes);
  if (!chart_->frames_follow()) return;
  turn_frames(whole_turn);
  chart_->set_frames({turned_frames_, turned_tangents_}, angle_, out);
}

// Also takes from the angles what the turn of the reference gives them already, to first order.
void TurningChart::turn_frames(const Quat& whole_turn) {
  const std::vector<Quat>& frames = chart_->reference().frames;
  const Points& tangents = chart_->start().tangents;
  const auto less_turn = [&](Index j, const Vec3& spin) {
    if (chart_->angle_unknown(j) >= 0) angle_[j] -= spin.dot(tangents.col(j));
  };
  for_each_in_lanes(0, rigid_frames_, [&]<class T>(Index j) {
    const QuatOf<T> turn{whole_turn.w(), whole_turn.x(), whole_turn.y(), whole_turn.z()};
    store_quats(turn * load_quats<T>(frames.data(), j), turned_frames_.data(), j);
    store_columns(times(turn_, load_columns<T>(tangents, j)), turned_tangents_, j);
  });
  for (Index j = 0; j < rigid_frames_; ++j) less_turn(j, omega_);
  for (Index j = rigid_frames_; j < tangents.cols(); ++j) {
    const Vec3 spin = frame_weight_[j] * omega_;
    const Quat turn = rotation_of(spin);
    turned_frames_[static_cast<std::size_t>(j)] = turn * frames[static_cast<std::size_t>(j)];
    turned_tangents_.col(j) = turn * tangents.col(j);
    less_turn(j, spin);
  }
}

void TurningChart::pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                             const Points& by_move, Eigen::VectorXd& by_x, Eigen::VectorXd& by_z) {
  const bool moves_count = by_move.cols() > 0;
  const bool frames_follow = chart_->frames_follow();
  force_ = by_node;
  if (frames_follow) {
    const FrameChart::Start start =
        turns_ ? FrameChart::Start{turned_frames_, turned_tangents_} : chart_->start();
    chart_->pull_back_frames(start, state, by_frame, force_, by_angle_);
  }
  by_x.resize(chart_->size());
  chart_->gather(force_, by_x);
  if (frames_follow) chart_->gather_angles(by_angle_, by_x);
  by_z = by_x;
  if (!turns_) {
    if (!moves_count) return;
    back_ = force_ + by_move;
    chart_->gather(back_, by_z);
    return;
  }
  // what is held follows no turn
  chart_->clear_held(force_);
  const RodState& reference = chart_->reference();
  const Index n = reference.node_count();
  // The rigid nodes share one turn: their torques are summed before it is undone.
  Vec3 by_omega = jacobian_transposed(omega_, sum_of_crosses(state.nodes, force_, rigid_nodes_));
  const Mat3 turn_back = turn_.transpose();
  for_each_in_lanes(0, rigid_nodes_, [&]<class T>(Index i) {
    store_columns(times(turn_back, load_columns<T>(force_, i)), back_, i);
  });
  for (Index i = rigid_nodes_; i < n; ++i) {
    const double w = node_weight_[i];
    const Vec3 force = force_.col(i);
    back_.col(i) = node_turn_[static_cast<std::size_t>(i - rigid_nodes_)].transpose() * force;
    by_omega += w * jacobian_transposed(w * omega_, Vec3(state.nodes.col(i)).cross(force));
  }
  if (moves_count) back_ += by_move;
  by_omega -= sum_of_crosses(weighted_, back_, n);
  if (frames_follow) by_omega += by_turning_frames(state);
  const Mat3 turning = hat(inverse_inertia_ * by_omega);
  for_each_in_lanes(0, n, [&]<class T>(Index i) {
    store_columns(load_columns<T>(back_, i) + times(turning, load_columns<T>(weighted_, i)), back_,
                  i);
  });
  chart_->gather(back_, by_z);
}

// Turning the reference under a fixed tangent t spins the frame about t by
// (t + t0').spin / (1 + t.t0'), t0' the turned reference tangent.
Vec3 TurningChart::by_turning_frames(const RodState& state) const {
  const Index frames = by_angle_.size();
  const Points& tangents = chart_->start().tangents;
  // the angle of a held frame does not follow the turn
  Eigen::VectorXd by_angle(frames);
  for (Index j = 0; j < frames; ++j) {
    by_angle[j] = chart_->angle_unknown(j) >= 0 ? by_angle_[j] : 0.0;
  }
  const auto spin_axis = [&]<class T>(T, Index j) {
    const Triple<T> t = third_axis(load_quats<T>(state.frames.data(), j));
    const Triple<T> t0 = load_columns<T>(turned_tangents_, j);
    return (1.0 / (1.0 + dot(t, t0))) * (t + t0);
  };
  TripleSum by_turn, by_tangent;
  for_each_in_lanes(0, rigid_frames_, [&]<class T>(Index j) {
    const T g = load<T>(by_angle.data() + j);
    by_turn.add(g * spin_axis(T(), j));
    by_tangent.add(g * load_columns<T>(tangents, j));
  });
  Vec3 by_omega = jacobian_transposed(omega_, by_turn.total()) - by_tangent.total();
  for (Index j = rigid_frames_; j < frames; ++j) {
    const double w = frame_weight_[j];
    if (w == 0) continue;
    by_omega += w * by_angle[j] *
                (jacobian_transposed(w * omega_, vec3(spin_axis(double(), j))) - tangents.col(j));
  }
  return by_omega;
}

}  // namespace wirepack
