#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Points measured on the centreline of a wire.
struct MeasuredPoints {
  Points position;         ///< 3 x N [length]
  Eigen::VectorXd arc;     ///< N, or empty when unknown [length]
  Eigen::VectorXd sigma;   ///< N, standard error of each coordinate, or empty when unknown [length]
  std::vector<long> line;  ///< N, where each comes from in its file; may be empty
  double resolution = 0;   ///< to which coordinates are rounded; 0: not at all [length]
  bool ordered = false;    ///< in the sense of growing arc; true with arcs

  Index count() const { return position.cols(); }
};

}  // namespace wirepack
