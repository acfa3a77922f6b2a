#include "wirepack/fit/darboux_curve.hpp"

#include <algorithm>
#include <ceres/jet.h>
#include <cmath>
#include <limits>

#include "screw_motion.hpp"

namespace wirepack {

namespace {

// k0 is constant over a piece, at its value in the middle: 16 pieces to a knot interval.
constexpr Index pieces_per_interval = 16;

using Jet = ceres::Jet<double, 3>;

// A screw motion with its derivative by the Darboux vector: turn of the frame and shift of the
// place, both in the axes of the start.
struct ScrewDerivative {
  Placement<double> motion;
  Mat3 turn, shift;
};

ScrewDerivative screw_derivative(const Vec3& darboux, double s) {
  Eigen::Matrix<Jet, 3, 1> k;
  for (int i = 0; i < 3; ++i) k[i] = Jet(darboux[i], i);
  const Placement<Jet> jets = screw_motion<Jet>(k, Jet(s));
  ScrewDerivative result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result.motion.rotation(i, j) = jets.rotation(i, j).a;
    result.motion.position[i] = jets.position[i].a;
    result.shift.row(i) = jets.position[i].v.transpose();
  }
  for (int a = 0; a < 3; ++a) {
    Mat3 by_k;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) by_k(i, j) = jets.rotation(i, j).v[a];
    }
    const Mat3 spin = by_k * result.motion.rotation.transpose();  // antisymmetric
    result.turn.col(a) = Vec3(spin(2, 1), spin(0, 2), spin(1, 0));
  }
  return result;
}

DarbouxCurve::Pose moved(const DarbouxCurve::Pose& from, const Placement<double>& by) {
  return {from.directors * by.rotation, from.position + from.directors * by.position};
}

}  // namespace

std::vector<DarbouxBasis::Weight> DarbouxBasis::weights(double arc) const {
  if (intervals == 0) {
    std::vector<Weight> result{{0, 0, 1}, {1, 1, 1}};
    if (!planar) result.push_back({2, 2, 1});
    return result;
  }
  const double u = std::clamp((arc - first) / (last - first), 0.0, 1.0) * double(intervals);
  const Index i = std::min(static_cast<Index>(u), intervals - 1);
  const double t = u - static_cast<double>(i), r = 1 - t;
  const std::array<double, 4> cubic{r * r * r / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                    (3 * r * r * r - 6 * r * r + 4) / 6, t * t * t / 6};
  std::vector<Weight> result;
  for (int component = 0; component < 2; ++component) {
    for (Index q = 0; q < 4; ++q) {
      result.push_back(
          {component * (intervals + 3) + i + q, component, cubic[static_cast<std::size_t>(q)]});
    }
  }
  return result;
}

Vec3 DarbouxBasis::darboux(const Eigen::VectorXd& unknowns, double arc) const {
  Vec3 k = Vec3::Zero();
  for (const Weight& w : weights(arc)) {
    k[w.component] += w.value * unknowns[DarbouxCurve::pose_size + w.unknown];
  }
  return k;
}

DarbouxCurve::DarbouxCurve(DarbouxBasis basis, Pose pose)
    : basis_(basis), pose_(std::move(pose)), middle_(basis.middle()), step_(0) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (basis_.intervals == 0) {
    sides_[0].push_back({middle_, infinity, {}, {}, {}, {}, {}});
    sides_[1].push_back({middle_, -infinity, {}, {}, {}, {}, {}});
  } else {
    step_ = (basis_.last - basis_.first) / double(pieces_per_interval * basis_.intervals);
    for (std::size_t side = 0; side < 2; ++side) {
      const double sign = side == 0 ? 1 : -1;
      const Index count = pieces_per_interval * basis_.intervals / 2;
      for (Index i = 0; i <= count; ++i) {  // the last one goes on without end
        const double from = middle_ + sign * step_ * double(i);
        sides_[side].push_back(
            {from, i < count ? from + sign * step_ : sign * infinity, {}, {}, {}, {}, {}});
      }
    }
  }
  for (auto& side : sides_) {
    for (Piece& piece : side) {
      const double middle = std::isfinite(piece.to)
                                ? (piece.from + piece.to) / 2
                                : piece.from + std::copysign(step_ / 2, piece.to);
      piece.weights = basis_.weights(middle);
    }
  }
  set_unknowns(Eigen::VectorXd::Zero(size()), false);
}

void DarbouxCurve::set_unknowns(const Eigen::VectorXd& unknowns, bool derivatives) {
  unknowns_ = unknowns;
  const ScrewDerivative tilt = screw_derivative(Vec3(unknowns[0], unknowns[1], 0), 1);
  const Pose middle{pose_.directors * tilt.motion.rotation,
                    pose_.position + pose_.directors * unknowns.segment<3>(2)};
  Eigen::Matrix3Xd turn, shift;
  if (derivatives) {
    turn = Eigen::Matrix3Xd::Zero(3, size());
    shift = Eigen::Matrix3Xd::Zero(3, size());
    for (Index a = 0; a < 2; ++a) {
      turn.col(a) = pose_.directors * tilt.turn.col(a);
      shift.col(a) = -turn.col(a).cross(middle.position);
    }
    shift.middleCols<3>(2) = pose_.directors;
  }
  for (auto& side : sides_) integrate(side, middle, turn, shift, derivatives);
}

void DarbouxCurve::integrate(std::vector<Piece>& side, Pose pose, const Eigen::Matrix3Xd& turn,
                             const Eigen::Matrix3Xd& shift, bool derivatives) {
  for (std::size_t i = 0; i < side.size(); ++i) {
    Piece& piece = side[i];
    piece.darboux.setZero();
    for (const auto& w : piece.weights) {
      piece.darboux[w.component] += w.value * unknowns_[pose_size + w.unknown];
    }
    piece.start = pose;
    if (derivatives && i == 0) {
      piece.turn = turn;
      piece.shift = shift;
    }
    if (i + 1 == side.size()) break;
    const double length = piece.to - piece.from;
    if (!derivatives) {
      pose = moved(pose, screw_motion<double>(piece.darboux, length));
      continue;
    }
    const ScrewDerivative screw = screw_derivative(piece.darboux, length);
    pose = moved(piece.start, screw.motion);
    Piece& next = side[i + 1];
    next.turn = piece.turn;
    next.shift = piece.shift;
    const Mat3 turns = piece.start.directors * screw.turn;
    const Mat3 shifts = piece.start.directors * screw.shift;
    for (const auto& w : piece.weights) {
      const Vec3 by_turn = w.value * turns.col(w.component);
      next.turn.col(pose_size + w.unknown) += by_turn;
      next.shift.col(pose_size + w.unknown) +=
          w.value * shifts.col(w.component) - by_turn.cross(pose.position);
    }
  }
}

const DarbouxCurve::Piece& DarbouxCurve::piece_at(double arc) const {
  const auto& side = sides_[arc >= middle_ ? 0 : 1];
  if (side.size() == 1) return side.front();
  const double place = std::abs(arc - middle_) / step_;
  const double last = double(side.size() - 1);
  return side[static_cast<std::size_t>(place < last ? place : last)];  // also of what is no number
}

DarbouxCurve::Pose DarbouxCurve::at(double arc) const {
  const Piece& piece = piece_at(arc);
  return moved(piece.start, screw_motion<double>(piece.darboux, arc - piece.from));
}

void DarbouxCurve::by_unknowns(
    double arc, const Pose& there, const Mat3& directions,
    Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>> out) const {
  const Piece& piece = piece_at(arc);
  Mat3 lever;  // n . (turn x r) = turn . (r x n)
  for (int a = 0; a < 3; ++a) lever.col(a) = there.position.cross(Vec3(directions.col(a)));
  out.noalias() = lever.transpose().lazyProduct(piece.turn);
  out.noalias() += directions.transpose().lazyProduct(piece.shift);
  const Mat3 within = directions.transpose() * piece.start.directors *
                      screw_derivative(piece.darboux, arc - piece.from).shift;
  for (const auto& w : piece.weights) {
    out.col(pose_size + w.unknown) += w.value * within.col(w.component);
  }
}

double DarbouxCurve::foot(const Vec3& point, double arc) const {
  for (int round = 0; round < 30; ++round) {
    const Piece& piece = piece_at(arc);
    const Pose here = moved(piece.start, screw_motion<double>(piece.darboux, arc - piece.from));
    const Vec3 away = point - here.position;
    const Vec3& k = piece.darboux;
    const Vec3 bend = here.directors * Vec3(k.y(), -k.x(), 0);  // k x e3, t' in the world
    // Beyond the centre of curvature Newton's step would go uphill.
    const double slope = std::max(1 - bend.dot(away), 0.3);
    const double limit = 0.5 / std::max(bend.norm(), 1e-300);
    const double step = std::clamp(here.directors.col(2).dot(away) / slope, -limit, limit);
    if (!std::isfinite(step)) break;
    arc += step;
    // What is left changes the distance by its square only.
    if (std::abs(step) < 1e-10 * limit || std::abs(step) < 1e-10 * std::abs(arc - middle_)) break;
  }
  return arc;
}

}  // namespace wirepack
