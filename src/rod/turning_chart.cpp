#include "wirepack/rod/turning_chart.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

// A rotation without trigonometry: about v by 2 atan(|v| / 2).
template <class T>
QuatOf<T> cayley_rotation(const Triple<T>& v) {
  using std::sqrt;
  const Triple<T> u = T(0.5) * v;
  const T w = 1.0 / sqrt(1.0 + dot(u, u));
  return {w, w * u.x, w * u.y, w * u.z};
}

// What a torque b on a body that the rotation above has turned is by v: A^T b, where the rotation
// of v + dv is a turn by A dv after that of v; A = (I + hat(v) / 2) / (1 + v.v / 4).
template <class T>
Triple<T> by_cayley_vector(const Triple<T>& v, const Triple<T>& b) {
  const Triple<T> u = T(0.5) * v;
  return (1.0 / (1.0 + dot(u, u))) * (b - cross(u, b));
}

double taper_weight(double arc, double taper) {
  const double u = std::min(1.0, arc / taper);
  return u * u * (3 - 2 * u);
}

// The same vector in all lanes.
template <class T>
Triple<T> spread(const Vec3& v) {
  return {T(v.x()), T(v.y()), T(v.z())};
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
  angle_weight_ = frame_weight_;
  double arc = 0;
  for (Index j = reference.edge_count(); j-- > 0;) {
    const double length =
        (reference.nodes.col(next_node(reference, j)) - reference.nodes.col(j)).norm();
    frame_weight_[j] = taper_weight(arc + length / 2, taper);
    if (chart.angle_unknown(j) >= 0) angle_weight_[j] = frame_weight_[j];
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
  turn_ = quat(cayley_rotation(triple(omega_))).toRotationMatrix();
  for_each_in_lanes(0, n, [&]<class T>(Index i) {
    store_columns(load_columns<T>(step_, i) - times(spin, load_columns<T>(weighted_, i)), moves_,
                  i);
  });
  const auto moved = [&]<class T>(T, Index i) {
    return load_columns<T>(reference.nodes, i) + load_columns<T>(moves_, i);
  };
  for_each_in_lanes(0, rigid_nodes_, [&]<class T>(Index i) {
    store_columns(times(turn_, moved(T(), i)), out.nodes, i);
  });
  for_each_in_lanes(rigid_nodes_, n, [&]<class T>(Index i) {
    const T weight = load<T>(node_weight_.data() + i);
    store_columns(cayley_rotation(weight * spread<T>(omega_)) * moved(T(), i), out.nodes, i);
  });
  chart_->restore_held(out.nodes);
  if (!chart_->frames_follow()) return;
  turn_frames();
  chart_->set_frames({turned_frames_, turned_tangents_}, angle_, out);
}

// Also takes from the angles what the turn of the reference gives them already, to first order.
void TurningChart::turn_frames() {
  const std::vector<Quat>& frames = chart_->reference().frames;
  const Points& tangents = chart_->start().tangents;
  const Index count = tangents.cols();
  const Quat whole_turn = quat(cayley_rotation(triple(omega_)));
  for_each_in_lanes(0, rigid_frames_, [&]<class T>(Index j) {
    const QuatOf<T> turn{whole_turn.w(), whole_turn.x(), whole_turn.y(), whole_turn.z()};
    store_quats(turn * load_quats<T>(frames.data(), j), turned_frames_.data(), j);
    store_columns(times(turn_, load_columns<T>(tangents, j)), turned_tangents_, j);
  });
  for_each_in_lanes(rigid_frames_, count, [&]<class T>(Index j) {
    const T weight = load<T>(frame_weight_.data() + j);
    const QuatOf<T> turn = cayley_rotation(weight * spread<T>(omega_));
    store_quats(turn * load_quats<T>(frames.data(), j), turned_frames_.data(), j);
    store_columns(turn * load_columns<T>(tangents, j), turned_tangents_, j);
  });
  for_each_in_lanes(0, count, [&]<class T>(Index j) {
    const T spin = dot(spread<T>(omega_), load_columns<T>(tangents, j));
    const T weight = load<T>(angle_weight_.data() + j);
    store(load<T>(angle_.data() + j) - weight * spin, angle_.data() + j);
  });
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
  const Index n = chart_->reference().node_count();
  // The rigid nodes share one turn: their torques are summed before it is undone.
  const Vec3 torque = sum_of_crosses(state.nodes, force_, rigid_nodes_);
  const Mat3 turn_back = turn_.transpose();
  for_each_in_lanes(0, rigid_nodes_, [&]<class T>(Index i) {
    store_columns(times(turn_back, load_columns<T>(force_, i)), back_, i);
  });
  TripleSum by_taper;
  for_each_in_lanes(rigid_nodes_, n, [&]<class T>(Index i) {
    const T weight = load<T>(node_weight_.data() + i);
    const Triple<T> v = weight * spread<T>(omega_), force = load_columns<T>(force_, i);
    store_columns(cayley_rotation(v).conjugate() * force, back_, i);
    by_taper.add(weight * by_cayley_vector(v, cross(load_columns<T>(state.nodes, i), force)));
  });
  Vec3 by_omega = vec3(by_cayley_vector(triple(omega_), triple(torque))) + by_taper.total();
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
  const Points& tangents = chart_->start().tangents;
  const auto by_spin = [&]<class T>(T by_angle, Index j) {
    const Triple<T> t = third_axis(load_quats<T>(state.frames.data(), j));
    const Triple<T> t0 = load_columns<T>(turned_tangents_, j);
    return (by_angle / (1.0 + dot(t, t0))) * (t + t0);
  };
  const auto weighted_by_angle = [&]<class T>(T, Index j) {
    return load<T>(angle_weight_.data() + j) * load<T>(by_angle_.data() + j);
  };
  TripleSum by_turn, by_taper, by_tangent;
  for_each_in_lanes(0, rigid_frames_, [&]<class T>(Index j) {
    const T by_angle = weighted_by_angle(T(), j);
    by_turn.add(by_spin(by_angle, j));
    by_tangent.add(by_angle * load_columns<T>(tangents, j));
  });
  for_each_in_lanes(rigid_frames_, tangents.cols(), [&]<class T>(Index j) {
    const T by_angle = weighted_by_angle(T(), j);
    const Triple<T> v = load<T>(frame_weight_.data() + j) * spread<T>(omega_);
    by_taper.add(by_cayley_vector(v, by_spin(by_angle, j)));
    by_tangent.add(by_angle * load_columns<T>(tangents, j));
  });
  return vec3(by_cayley_vector(triple(omega_), triple(by_turn.total()))) + by_taper.total() -
         by_tangent.total();
}

}  // namespace wirepack
