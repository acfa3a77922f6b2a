#include "wirepack/dynamics/friction.hpp"

#include <algorithm>
#include <utility>

namespace wirepack {

namespace {

template <class A, class B>
bool earlier(const A& a, const B& b) {
  return std::pair(a.first, a.second) < std::pair(b.first, b.second);
}

// Memory of the strongest contact between neighbouring edges, which has moved on to these; or null.
const StickAnchor* inherited(const std::vector<StickAnchor>& memory, const Touch& touch) {
  const StickAnchor* strongest = nullptr;
  for (Index first = touch.first - 1; first <= touch.first + 1; ++first) {
    const std::pair lowest(first, touch.second - 1);
    auto it = std::lower_bound(memory.begin(), memory.end(), lowest,
                               [](const StickAnchor& a, const std::pair<Index, Index>& key) {
                                 return std::pair(a.first, a.second) < key;
                               });
    for (; it != memory.end() && it->first == first && it->second <= touch.second + 1; ++it) {
      if (strongest == nullptr || it->normal_force > strongest->normal_force) strongest = &*it;
    }
  }
  return strongest;
}

// Turns a spring into the present tangent plane and keeps its length.
Vec3 carried(const Vec3& spring, const SurfaceSlip& slip) {
  const Vec3 flat = slip.tangential(spring);
  const double before = spring.norm(), now = flat.norm();
  return now > 0 ? Vec3(flat * (before / now)) : flat;
}

}  // namespace

FrictionReport add_friction(const StickSlipLaw& law, std::span<const Touch> touches,
                            const WireMotion& motion, double step, std::vector<StickAnchor>& memory,
                            Gradient& gradient) {
  FrictionReport report;
  std::vector<StickAnchor> next;
  next.reserve(touches.size());
  auto known = memory.cbegin();
  for (const Touch& touch : touches) {
    while (known != memory.cend() && earlier(*known, touch)) ++known;
    const bool same = known != memory.cend() && !earlier(touch, *known);
    const StickAnchor* before = same                ? &*known
                                : touch.second >= 0 ? inherited(memory, touch)
                                                    : nullptr;
    const Vec3 rate = touch.slip.of(motion.velocity, motion.angular_velocity);
    StickAnchor anchor{touch.first, touch.second, step * rate, touch.normal_force, false};
    if (before != nullptr) {
      anchor.spring += carried(before->spring, touch.slip);
      anchor.sliding = before->sliding;
    }
    const double stiffness = law.stiffness_ratio * touch.stiffness;
    const Vec3 drag = law.relaxation_time * stiffness * rate;
    Vec3 force = -stiffness * anchor.spring - drag;
    const double size = force.norm();
    const double kinetic = law.dynamic_coefficient * touch.normal_force;
    const double limit = anchor.sliding ? kinetic : law.static_coefficient * touch.normal_force;
    anchor.sliding = size > limit;
    if (anchor.sliding) {
      force *= kinetic / size;
      anchor.spring = -(force + drag) / stiffness;
    }
    touch.slip.add_force(-force, gradient.node, gradient.frame);
    report.power += force.dot(rate);
    report.stored += stiffness / 2 * anchor.spring.squaredNorm();
    next.push_back(anchor);
  }
  memory = std::move(next);
  return report;
}

}  // namespace wirepack
