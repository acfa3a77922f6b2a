#include "wirepack/observe/contact_patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "wirepack/observe/order.hpp"

namespace wirepack {

namespace {

/// Which pairs hang together: each points to another of its patch, the first one to itself.
class Groups {
 public:
  explicit Groups(std::size_t count) : leader_(count) {
    for (std::size_t k = 0; k < count; ++k) leader_[k] = k;
  }
  std::size_t first(std::size_t k) {
    while (leader_[k] != k) k = leader_[k] = leader_[leader_[k]];
    return k;
  }
  void join(std::size_t a, std::size_t b) {
    a = first(a);
    b = first(b);
    leader_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> leader_;
};

using Place = std::pair<Index, Index>;

Groups group(const std::map<Place, std::size_t>& number_at) {
  Groups groups(number_at.size());
  for (const auto& [place, k] : number_at) {
    for (Index i = place.first - 1; i <= place.first + 1; ++i) {
      for (Index j = place.second - 1; j <= place.second + 1; ++j) {
        const auto neighbour = number_at.find({i, j});
        if (neighbour != number_at.end()) groups.join(k, neighbour->second);
      }
    }
  }
  return groups;
}

}  // namespace

std::vector<ContactPatch> contact_patches(const RodState& state,
                                          const std::vector<SelfContact>& contacts) {
  std::map<Place, double> force_at;
  for (const SelfContact& contact : contacts) {
    if (contact.force > 0) force_at[{contact.edges.first, contact.edges.second}] += contact.force;
  }
  std::map<Place, std::size_t> number_at;
  for (const auto& [place, force] : force_at) number_at.emplace(place, number_at.size());
  Groups groups = group(number_at);
  const Points tangents = edge_tangents(state);
  std::map<std::size_t, ContactPatch> patches;
  for (const auto& [place, force] : force_at) {
    ContactPatch& patch = patches[groups.first(number_at.at(place))];
    const Vec3 t = tangents.col(place.first), u = tangents.col(place.second);
    const double angle = std::atan2(t.cross(u).norm(), std::abs(t.dot(u)));
    patch.angle += force * angle;
    patch.force += force;
    ++patch.pairs;
  }
  std::vector<ContactPatch> result;
  for (const auto& [first, patch] : patches) {
    result.push_back({patch.pairs, patch.force, patch.angle / patch.force});
  }
  return result;
}

}  // namespace wirepack
