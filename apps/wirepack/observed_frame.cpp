#include "observed_frame.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "wirepack/observe/loop_sizes.hpp"
#include "wirepack/observe/order.hpp"
#include "wirepack/packing/imperfection.hpp"

namespace wirepack {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double energy_unit(const ObservedFrame& o) { return units_of(o.scenario).scaled_energy(); }
double radius(const ObservedFrame& o) { return o.scenario.cavity.radius; }
double wire_radius(const ObservedFrame& o) { return o.scenario.wire.radius; }

void observe_contacts(const PackingFrame& frame, ObservedFrame& o) {
  o.contacts = contact_patches(frame.rod, frame.contacts);
  std::vector<double> forces, angles;
  for (const ContactPatch& patch : o.contacts) {
    forces.push_back(patch.force);
    angles.push_back(patch.angle);
  }
  o.contact_force = sample(forces);
  o.contact_angle = sample(angles);
}

using Frame = const ObservedFrame&;
constexpr std::array<Quantity, 31> quantities{{
    {"increment", "", [](Frame o) { return static_cast<double>(o.increment); }, true},
    {"inserted_length", "length", [](Frame o) { return o.row.inserted_length; }},
    {"packing_density", "", [](Frame o) { return o.row.packing_density; }},
    {"bend_energy", "YI/R", [](Frame o) { return o.row.energy_bend / energy_unit(o); }},
    {"twist_energy", "YI/R", [](Frame o) { return o.row.energy_twist / energy_unit(o); }},
    {"scaled_force", "YI/R^2", [](Frame o) { return o.row.scaled_force; }},
    {"axis_order", "", [](Frame o) { return o.coils.axis_order; }},
    {"feed_alignment", "", [](Frame o) { return o.coils.feed_alignment; }},
    {"tangent_order", "", [](Frame o) { return o.tangent_order; }},
    {"reversals", "", [](Frame o) { return static_cast<double>(o.coils.reversals); }, true},
    {"twist", "turns", [](Frame o) { return o.coils.twist; }},
    {"writhe", "", [](Frame o) { return o.coils.writhe; }},
    {"tip_rotation", "turns", [](Frame o) { return o.coils.tip_rotation(); }},
    {"average_crossings", "", [](Frame o) { return o.coils.average_crossing_number; }},
    {"knot_determinant", "", [](Frame o) { return static_cast<double>(o.knot.determinant); }, true},
    {"spacing", "a",
     [](Frame o) { return o.spacing.pairs > 0 ? o.spacing.mean / wire_radius(o) : nothing; }},
    {"spacing_across", "a",
     [](Frame o) { return o.spacing.pairs > 0 ? o.spacing.across / wire_radius(o) : nothing; }},
    {"hexagonal_order", "",
     [](Frame o) { return o.spacing.ordered > 0 ? o.spacing.hexagonal_order : nothing; }},
    {"contacts", "", [](Frame o) { return static_cast<double>(o.contacts.size()); }, true},
    {"contacts_per_length", "1/2a",
     [](Frame o) {
       return 2 * static_cast<double>(o.contacts.size()) * 2 * wire_radius(o) /
              o.row.inserted_length;
     }},
    {"contact_force", "YI/R^2",
     [](Frame o) { return o.contact_force.mean / force_unit(o.scenario); }},
    {"contact_force_sd", "YI/R^2",
     [](Frame o) { return o.contact_force.deviation / force_unit(o.scenario); }},
    {"contact_angle", "deg", [](Frame o) { return o.contact_angle.mean * 180 / pi; }},
    {"bend_log_mu", "", [](Frame o) { return o.bend_energy.mu; }},
    {"bend_log_sigma", "", [](Frame o) { return o.bend_energy.sigma; }},
    {"bend_log_mean", "", [](Frame o) { return o.bend_energy.fitted_mean(); }},
    {"bend_log_distance", "", [](Frame o) { return o.bend_energy.ks_distance; }},
    {"curvature", "1/R", [](Frame o) { return o.curvature.mean * radius(o); }},
    {"curvature_sd", "1/R", [](Frame o) { return o.curvature.deviation * radius(o); }},
    {"loop_length", "2 pi R", [](Frame o) { return o.loops.mean / (2 * pi * radius(o)); }},
    {"loop_length_sd", "2 pi R", [](Frame o) { return o.loops.deviation / (2 * pi * radius(o)); }},
}};

}  // namespace

ObservedFrame observe_frame(const std::string& run, const Scenario& scenario, const HistoryRow& row,
                            PackingFrame frame) {
  ObservedFrame o;
  o.run = run;
  o.scenario = scenario;
  o.row = row;
  o.increment = static_cast<std::int64_t>(frame.increment);
  RodState& rod = frame.rod;
  rod.twist_guide.assign(static_cast<std::size_t>(rod.node_count()), 0.0);
  o.coils = coil_report(rod, drawn_setup(scenario).nozzle.direction);
  o.tangent_order = axial_order(edge_tangents(rod)).order();
  o.spacing = strand_spacing(rod);
  observe_contacts(frame, o);
  const double* energies = frame.bend_energy.data();
  o.bend_energy = fit_log_normal_over_mean({energies, energies + frame.bend_energy.size()});
  o.curvature = sample(local_curvatures(rod));
  o.loops = sample(loop_lengths(rod));
  o.knot = knot_type(closed_outside(rod.nodes));
  const double a = scenario.wire.radius, cavity = scenario.cavity.radius;
  if (!scenario.cavity.semi_axes) {  // spherical shells in a sphere
    o.density = radial_density(rod, a, cavity, static_cast<Index>(std::ceil(4 * cavity / a)));
  }
  o.order = order_by_shell(rod, scenario.cavity, 2 * a);
  return o;
}

std::span<const Quantity> frame_quantities() { return quantities; }

}  // namespace wirepack
