#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace wirepack {

using Index = Eigen::Index;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// 3 x N: one point or vector per column.
using Points = Eigen::Matrix3Xd;
/// Rotation frame -> world. In memory x, y, z, w (Eigen); files keep w first.
using Quat = Eigen::Quaterniond;

inline constexpr double pi = 3.14159265358979323846;

}  // namespace wirepack
