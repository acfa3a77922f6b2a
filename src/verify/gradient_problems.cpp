#include <cmath>

#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/solve/gradient_check.hpp"

#include "problems.hpp"

namespace wirepack {

namespace {

// A tight, irregular coil that touches itself and the wall, clamped at its end.
RodState crowded_coil(const RodParams& params) {
  Random random(17);
  const Index count = 60;
  Points nodes(3, count);
  for (Index i = 0; i < count; ++i) {
    const double angle = 0.32 * static_cast<double>(i);
    nodes.col(i) =
        Vec3(3 * std::cos(angle), 3 * std::sin(angle), 0.09 * static_cast<double>(i) - 2);
    for (double& x : nodes.col(i)) x += 0.05 * random.symmetric();
  }
  RodState state = make_rod(nodes, params, {.last_clamped = true});
  for (Quat& frame : state.frames) {
    frame = rotation_about(third_axis(frame), 0.3 * random.symmetric()) * frame;
  }
  state.inlet_rest_length = 1.2;
  return state;
}

template <EnergyTerm Energy>
void add_checks(std::vector<KnownProblem>& found, const RodState& state, Energy& energy) {
  const HeldUnknowns held = HeldUnknowns::none(state);
  Random random(23);
  Eigen::VectorXd offset(FrameChart(state, held).size());
  for (double& x : offset) x = 0.02 * random.symmetric();
  const EnergyTerms functions = EnergyTerms{energy};
  const GradientCheck check = check_gradient(state, held, functions, offset, 1e-6);
  // an energy that is flat here would pass without being looked at
  const double error = check.largest_derivative > 1e-3 ? check.relative_error : 1;
  found.push_back({std::string("gradient of ") + std::string(Energy::name) + ", largest error", 0,
                   error, 1e-7, "differences over 1e-6 are rounded by 1e-10"});
}

}  // namespace

std::vector<KnownProblem> gradient_problems() {
  RodParams params;
  params.rest_darboux = Vec3(0.05, 0.1, -0.07);
  const RodState state = crowded_coil(params);
  std::vector<KnownProblem> found;
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  WallEnergy wall(params, Cavity{4.1}, 5);
  SelfContactEnergy contact(params, ContactParams{});
  Loads loads;
  loads.forces.push_back({3, Vec3(0.3, -0.2, 0.5)});
  loads.moments.push_back({5, Vec3(1, 2, 2) / 3, 0.7, state.frames[5]});
  loads.weight = Vec3(0.1, 0, -0.2);
  LoadEnergy load(params, loads);
  add_checks(found, state, stretch);
  add_checks(found, state, joints);
  add_checks(found, state, wall);
  add_checks(found, state, contact);
  add_checks(found, state, load);
  EnergyTerms total{stretch, joints, wall, contact, load};
  const GradientCheck inlet = check_inlet_derivative(state, total, 1e-6);
  found.push_back({"derivative by the inserted length, error", 0, inlet.relative_error, 1e-6,
                   "differences over 1e-6 of an energy 100 times as large"});
  return found;
}

}  // namespace wirepack
