#pragma once

#include <vector>

#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// One saved moment of a run, with what is needed to look at it without the program.
struct PackingFrame {
  RodState rod;
  double increment = 0;
  double inserted_length = 0;
  double packing_density = 0;
  double force = 0;
  Eigen::VectorXd bend_energy;   ///< N, of the joint at each node
  Eigen::VectorXd twist_energy;  ///< N
  Eigen::VectorXd wall_force;    ///< N
  std::vector<SelfContact> contacts;
};

}  // namespace wirepack
