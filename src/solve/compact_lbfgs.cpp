#include "compact_lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wirepack/core/threads.hpp"

namespace wirepack {

namespace {

// Of the weak Wolfe conditions: the value falls by this share of what the slope promises at least,
// and the slope that is left is no steeper than this share of it.
constexpr double least_decrease = 1e-4, most_slope = 0.9;
constexpr int most_trials = 20;  // of one line search
// A tile of twenty pairs takes 650 kB, about a second-level cache. From the shared size on, threads
// pay.
constexpr Index tile_width = 2048, shared_size = 4 * tile_width;

// Vectors of one kind, in the columns of a matrix.
class Columns {
 public:
  // Columns start at multiples of a register, so that their sums have the same order wherever the
  // matrix lies.
  Columns(Index size, Index count) : size_(size), matrix_((size + 7) / 8 * 8, count) {}

  void set(Index column, const Eigen::VectorXd& v) { matrix_.col(column).head(size_) = v; }
  // Products of the first `used` columns with v.
  Eigen::VectorXd times(const Eigen::VectorXd& v, Index used) const {
    Eigen::MatrixXd parts(used, (size_ + tile_width - 1) / tile_width);
    for_each_tile(size_, tile_width, size_ >= shared_size, [&](Index from, Index to) {
      parts.col(from / tile_width).noalias() =
          matrix_.block(from, 0, to - from, used).transpose() * v.segment(from, to - from);
    });
    Eigen::VectorXd sum = parts.col(0);
    for (Index t = 1; t < parts.cols(); ++t) sum += parts.col(t);
    return sum;
  }
  auto rows(Index from, Index to, Index used) const {
    return matrix_.block(from, 0, to - from, used);
  }

 private:
  Index size_;
  Eigen::MatrixXd matrix_;
};

// The last pairs (s, y) of moves and changes of the gradient. A new pair takes the place of the
// oldest, so columns are in the order of a ring.
class PairMemory {
 public:
  PairMemory(Index size, Index capacity)
      : capacity_(capacity),
        moves_(size, capacity),
        changes_(size, capacity),
        move_change_(capacity, capacity),
        change_change_(capacity, capacity) {}

  void forget() { first_ = count_ = 0; }

  void add(const Eigen::VectorXd& move, const Eigen::VectorXd& change) {
    if (count_ < capacity_) {
      ++count_;
    } else {
      first_ = (first_ + 1) % capacity_;
    }
    const Index newest = column(count_ - 1);
    moves_.set(newest, move);
    changes_.set(newest, change);
    move_change_.col(newest).head(count_) = moves_.times(change, count_);
    change_change_.col(newest).head(count_) = changes_.times(change, count_);
    change_change_.row(newest).head(count_) = change_change_.col(newest).head(count_).transpose();
    scale_ = move_change_(newest, newest) / change_change_(newest, newest);
  }

  // -H g with the inverse Hessian H of the pairs (minimizer.hpp has the source):
  // H g = c g + S v - c Y u,  u = R^-1 S^T g,  v = R^-T ((D + c Y^T Y) u - c Y^T g),
  // R the upper triangle of S^T Y, D its diagonal, c = s.y / y.y of the newest pair.
  void direction(const Eigen::VectorXd& gradient, Eigen::VectorXd& result) const {
    if (count_ == 0) {
      result = -gradient;
      return;
    }
    const auto by_age = [&](const auto& ring) {
      return Eigen::VectorXd::NullaryExpr(count_, [&](Index i) { return ring[column(i)]; }).eval();
    };
    Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(count_, count_), middle(count_, count_);
    for (Index j = 0; j < count_; ++j) {
      for (Index i = 0; i < count_; ++i) {
        if (i <= j) upper(i, j) = move_change_(column(i), column(j));
        middle(i, j) = scale_ * change_change_(column(i), column(j));
      }
      middle(j, j) += upper(j, j);
    }
    const Eigen::VectorXd u =
        upper.triangularView<Eigen::Upper>().solve(by_age(moves_.times(gradient, count_)));
    const Eigen::VectorXd v = upper.transpose().triangularView<Eigen::Lower>().solve(
        middle * u - scale_ * by_age(changes_.times(gradient, count_)));
    Eigen::VectorXd of_moves(count_), of_changes(count_);
    for (Index i = 0; i < count_; ++i) {
      of_moves[column(i)] = -v[i];
      of_changes[column(i)] = scale_ * u[i];
    }
    const Index size = gradient.size();
    result.resize(size);
    for_each_tile(size, tile_width, size >= shared_size, [&](Index from, Index to) {
      auto part = result.segment(from, to - from);
      part = -scale_ * gradient.segment(from, to - from);
      part.noalias() += moves_.rows(from, to, count_) * of_moves;
      part.noalias() += changes_.rows(from, to, count_) * of_changes;
    });
  }

 private:
  // Column of the pair of this age, 0 the oldest. All columns before count_ are in use.
  Index column(Index age) const { return (first_ + age) % capacity_; }

  Index capacity_;
  Columns moves_, changes_;
  Eigen::MatrixXd move_change_, change_change_;  // products of columns
  Index first_ = 0, count_ = 0;
  double scale_ = 1;
};

struct LinePoint {
  double step, value, slope;
};

// Where the cubic through both values and slopes is lowest, within the inner eight tenths; the
// middle where there is no such place.
double between(const LinePoint& a, const LinePoint& b) {
  const double width = b.step - a.step;
  if (!std::isfinite(b.value)) return a.step + 0.1 * width;
  const double d = a.slope + b.slope - 3 * (b.value - a.value) / width;
  const double root = std::copysign(std::sqrt(d * d - a.slope * b.slope), width);
  const double share = 1 - (b.slope + root - d) / (b.slope - a.slope + 2 * root);
  return a.step + (std::isfinite(share) ? std::clamp(share, 0.1, 0.9) : 0.5) * width;
}

class CompactDescent {
 public:
  CompactDescent(const Objective& objective, const Eigen::VectorXd& start,
                 const DescentOptions& options)
      : objective_(objective),
        options_(options),
        memory_(start.size(), options.memory),
        y_(start) {}

  DescentReport run() {
    here_ = evaluate(y_, gradient_);
    std::optional<DescentEnd> end;
    if (here_.good_enough) end = DescentEnd::good_enough;
    while (!end) {
      memory_.direction(gradient_, direction_);
      if (!(direction_.dot(gradient_) < 0)) {
        memory_.forget();
        direction_ = -gradient_;
      }
      end = search_line();
    }
    return {*end, evaluations_};
  }

 private:
  Evaluation evaluate(const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    ++evaluations_;
    return objective_(y, gradient);
  }
  // Goes along the direction to a point with both Wolfe conditions, or ends the descent.
  std::optional<DescentEnd> search_line() {
    const double slope = direction_.dot(gradient_);
    if (!(slope < 0)) return DescentEnd::gave_up;
    LinePoint low{0, here_.value, slope};
    std::optional<LinePoint> high;
    double step = 1;
    for (int trial = 0; trial < most_trials; ++trial) {
      if (evaluations_ >= options_.max_evaluations) return DescentEnd::evaluation_limit;
      next_ = y_ + step * direction_;
      const Evaluation there = evaluate(next_, next_gradient_);
      if (there.good_enough) return DescentEnd::good_enough;
      const bool finite = std::isfinite(there.value) && next_gradient_.allFinite();
      const LinePoint point{step, finite ? there.value : HUGE_VAL,
                            finite ? direction_.dot(next_gradient_) : 0};
      if (!(point.value <= here_.value + least_decrease * step * slope)) {
        high = point;
      } else if (point.slope < most_slope * slope) {
        low = point;
      } else {
        memory_.add(next_ - y_, next_gradient_ - gradient_);
        y_.swap(next_);
        gradient_.swap(next_gradient_);
        here_ = there;
        return std::nullopt;
      }
      step = high ? between(low, *high) : 4 * step;
    }
    return DescentEnd::gave_up;
  }

  const Objective& objective_;
  const DescentOptions& options_;
  PairMemory memory_;
  Eigen::VectorXd y_, gradient_, direction_, next_, next_gradient_;
  Evaluation here_{};
  int evaluations_ = 0;
};

}  // namespace

DescentReport compact_lbfgs(const Objective& objective, const Eigen::VectorXd& start,
                            const DescentOptions& options) {
  return CompactDescent(objective, start, options).run();
}

}  // namespace wirepack
