#pragma once

#include "wirepack/packing/history.hpp"

namespace wirepack {

/// Balance of int F dL: work = energy + released + remeshing + friction + contact_springs + viscous
/// + residue.
struct WorkBalance {
  /// Energy of the wire that was inside at the start, plus the trapezoidal sum of the force over
  /// the inserted length. Runs in time add the work of the viscous medium.
  double work = 0;
  double released = 0;   ///< lost in snaps
  double remeshing = 0;  ///< energy that splits of the inlet edge have taken away (may be < 0)
  double friction = 0;   ///< dissipated by friction
  double contact_springs = 0;  ///< put into the springs of contacts that stick (SlipPotential)
  double viscous = 0;          ///< dissipated by viscous forces
};

/// Work that none of the other terms accounts for. `last` is the row at which the balance is drawn.
inline double residue(const WorkBalance& balance, const HistoryRow& last) {
  return balance.work - last.energy_total - last.energy_kinetic - balance.released -
         balance.remeshing - balance.friction - balance.contact_springs - balance.viscous;
}

/// Errors of the work, estimated from the increments so far.
struct WorkErrors {
  /// Steady error of the work over a whole edge, which reads the force at one phase of the mesh
  /// only; over that work, a mean over the last edges.
  double edge_share = 0;
  /// How far single edges are off beside that; over their work, a mean that fades while parts of
  /// edges are fed. Edges that were fed anew in parts count.
  double edge_scatter = 0;
  double trapezoid = 0;  ///< all other error of the work so far [energy]
};

/// An increment from equilibrium to equilibrium.
struct WorkStep {
  double fed;                  ///< inserted length
  double force_before, force;  ///< explicit, at both ends
  double spent;                ///< change of energy, and what went against friction
  double force_unit;           ///< YI / R^2
  bool whole_edge;             ///< the wire slid along itself by one edge
};

struct WorkBooking {
  double released;  ///< by a snap
  bool resolved;    ///< false: the work is not known well enough, so the increment should be halved
};

/// Adds the increment's work to the balance. Splits the difference between int F dL and what the
/// increment spent into energy released by a snap and error of the trapezoidal rule. It is a snap
/// if no force that is monotonic between both ends explains it. A whole edge never counts as a
/// snap: the force is read at one phase of the mesh only and has a steady error there, which only
/// parts of an edge can tell from a snap.
WorkBooking book(const WorkStep& step, WorkBalance& balance, WorkErrors& errors);

/// True if a whole edge under `force` is likely to be resolved, as far as the edges before tell. If
/// it is not, two halves cost less than the edge and then its parts.
bool whole_edge_is_likely_resolved(double edge_length, double force, double force_unit,
                                   const WorkBalance& balance, const WorkErrors& errors);

/// Books the energy that a split of the inlet edge has taken away (negative: added) as remeshing.
/// If it is more than a tenth of `edge_work`, the work over an edge, the split has set off a snap,
/// and it is booked as released. Returns what was released.
double book_split(double taken, double edge_work, WorkBalance& balance);

}  // namespace wirepack
