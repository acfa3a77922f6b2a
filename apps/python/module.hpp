#pragma once

#include <pybind11/pybind11.h>
#include <vector>

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

namespace py = pybind11;

/// Arrays of N x 3 and N x 4 numbers; wirepack_packer.py has looked at those that are handed in.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Quaternions = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Frames of so many edges (E x 4, scalar first) as they are given; carry_frames() brings them onto
/// the edges. Throws InvalidInput unless there are as many, each of which has a length.
std::vector<Quat> frames_of(const Quaternions& quaternion, Index edges);

/// As long as it lives, this thread computes with so many threads, 1 to most_threads. Throws
/// InvalidInput for others.
class Threads {
 public:
  explicit Threads(int count);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

/// How all is computed that is not told otherwise: by one thread, so that processes can be forked,
/// while others of Python go on.
struct Computing {
  Threads one{1};
  py::gil_scoped_release others{};
};

void add_packing(py::module_& module);
void add_observables(py::module_& module);

}  // namespace wirepack
