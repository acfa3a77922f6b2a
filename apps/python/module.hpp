#pragma once

#include <pybind11/pybind11.h>

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

namespace py = pybind11;

/// Arrays of N x 3 and N x 4 numbers; wirepack_packer.py has looked at those that are handed in.
using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Quaternions = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// Frames of the edges (E x 4, scalar first) as they are given; carry_frames() brings them onto the
/// edges. Throws InvalidInput unless there are as many, each of which has a length.
void set_frames(const Quaternions& quaternion, RodState& rod);

void add_packing(py::module_& module);
void add_observables(py::module_& module);

}  // namespace wirepack
