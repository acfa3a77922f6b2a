#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "wirepack/io/export.hpp"

#include "../node_values.hpp"

namespace wirepack {

ExportedFiles export_mmcif(const ExportSource& source) {
  const PackingFrame& frame = source.frames.back();
  const Eigen::VectorXd energy = scaled_bend_energy(source.scenario, frame);
  const Index n = frame.rod.node_count();
  // readers take no exponents: a millionth of the wire's radius in any unit
  const int decimals =
      std::max(0, 6 - static_cast<int>(std::floor(std::log10(source.scenario.wire.radius))));
  std::string text;
  for (const std::string& line : source.provenance) text += "# " + line + "\n";
  text +=
      "# one bead per node; a unit of length stands as an angstrom; B factor: bending energy per\n"
      "# length over YI/2R^2\n"
      "data_wirepack\n_entry.id wirepack\n_software.name wirepack\n"
      "_entity.id 1\n_entity.type polymer\n_struct_asym.id A\n_struct_asym.entity_id 1\n"
      "_entity_poly.entity_id 1\n_entity_poly.type other\n"
      "loop_\n_atom_site.group_PDB\n_atom_site.id\n_atom_site.type_symbol\n"
      "_atom_site.label_atom_id\n_atom_site.label_alt_id\n_atom_site.label_comp_id\n"
      "_atom_site.label_asym_id\n_atom_site.label_entity_id\n_atom_site.label_seq_id\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n"
      "_atom_site.B_iso_or_equiv\n_atom_site.auth_seq_id\n_atom_site.auth_asym_id\n"
      "_atom_site.pdbx_PDB_model_num\n";
  auto out = std::back_inserter(text);
  for (Index i = 0; i < n; ++i) {
    const Vec3 p = frame.rod.nodes.col(i);
    out = fmt::format_to(
        out, "ATOM {0} C CA . UNK A 1 {0} {1:.{5}f} {2:.{5}f} {3:.{5}f} 1 {4:.4f} {0} A 1\n", i + 1,
        p.x(), p.y(), p.z(), energy[i], decimals);
  }
  text +=
      "loop_\n_struct_conn.id\n_struct_conn.conn_type_id\n_struct_conn.ptnr1_label_asym_id\n"
      "_struct_conn.ptnr1_label_comp_id\n_struct_conn.ptnr1_label_seq_id\n"
      "_struct_conn.ptnr1_label_atom_id\n_struct_conn.ptnr2_label_asym_id\n"
      "_struct_conn.ptnr2_label_comp_id\n_struct_conn.ptnr2_label_seq_id\n"
      "_struct_conn.ptnr2_label_atom_id\n";
  for (Index i = 1; i < n; ++i) {
    out = fmt::format_to(out, "bond{0} covale A UNK {0} CA A UNK {1} CA\n", i, i + 1);
  }
  return {{source.target, text}};
}

}  // namespace wirepack
