#pragma once

#include "wirepack/packing/history.hpp"

namespace wirepack {

/// int F dL against the energy: work = energy + released + remeshing + friction + contact_springs +
/// viscous + residue.
struct WorkBalance {
  double work = 0;       ///< trapezoidal sum of the explicit force over the inserted length
  double released = 0;   ///< lost in snaps
  double remeshing = 0;  ///< energy that splits of the inlet edge have taken away (may be < 0)
  double friction = 0;   ///< dissipated by friction
  double contact_springs = 0;  ///< put into the springs of contacts that stick (SlipPotential)
  double viscous = 0;          ///< dissipated by viscous forces
};

/// What of the work has gone nowhere; `last` is the row up to which the balance goes.
inline double residue(const WorkBalance& balance, const HistoryRow& last) {
  return balance.work - last.energy_total - last.energy_kinetic - balance.released -
         balance.remeshing - balance.friction - balance.contact_springs - balance.viscous;
}

/// What the increments so far say of the errors of the work.
struct WorkErrors {
  /// Share of the work over a whole edge that the mesh at the inlet keeps: a mean over the last
  /// edges.
  double edge_share = 0;
  double trapezoid = 0;  ///< of the work so far: residue beyond what the mesh keeps
};

/// An increment from rest to rest.
struct WorkStep {
  double fed;                  ///< inserted length
  double force_before, force;  ///< explicit, at both ends
  double spent;                ///< change of energy, and what went against friction
  double force_unit;           ///< YI / R^2
  bool whole_edge;             ///< the wire slid along itself by one edge
};

struct WorkBooking {
  double released;  ///< by a snap
  bool resolved;    ///< false: the increment should be repeated in halves, as the work is not known
};

/// Adds the increment's work to the balance, and puts what int F dL misses of the change of energy
/// down to a snap or to the error of the trapezoid. It is a snap where no monotonous force between
/// both ends could do the same. Of a whole edge the force is read at one phase of the mesh only,
/// where it is steadily off; parts of an edge have to tell that from a snap.
WorkBooking book(const WorkStep& step, WorkBalance& balance, WorkErrors& errors);

/// Puts what a split of the inlet edge has taken away (negative: added) down to the mesh, or to a
/// snap that it set off where it is more than a tenth of `edge_work`, the work over an edge.
/// Returns what was released by a snap.
double book_split(double taken, double edge_work, WorkBalance& balance);

}  // namespace wirepack
