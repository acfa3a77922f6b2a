#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/packing/declared_units.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// A value that replaces or adds to those of a configuration file.
struct ConfigOverride {
  std::string assignment;             ///< "section.key=value", the value in TOML or a bare string
  std::string origin;                 ///< how messages name it, such as "--set cavity.radius=5"
  std::filesystem::path folder = {};  ///< names of files are relative to; empty: the current one
};

/// The scenario of a TOML configuration. Keys that are not given take the values of
/// default_scenario() for the given setup, cavity.radius, wire.radius and wire.youngs_modulus,
/// which may be given as stiffnesses, a persistence length or a wound coil
/// (data/docs/stiffness.md); insertion.increment follows a given wire.edge_length; any given stop
/// limit replaces the default one. wire.precurvature = k is the rest shape (0, k, 0).
/// wire.reference_shape takes its place: the name of a shape file (shape_file.hpp), relative to the
/// folder of `source`, or to that of an override; or its rows.
///
/// Throws InvalidInput with one line per problem, "file:line:column: section.key = value: what is
/// allowed", for all problems at once: syntax, unknown sections and keys, wrong types, impossible
/// values, a file without any key. `source` names the text in messages.
Scenario parse_config(std::string_view text, const std::string& source,
                      const std::vector<ConfigOverride>& overrides = {});

/// parse_config() of a file. Throws InvalidInput also when the file is missing, is not a regular
/// text file, or is larger than 1 MB; FileError when reading it fails.
Scenario read_config(const std::filesystem::path& file,
                     const std::vector<ConfigOverride>& overrides = {});

/// The files that a configuration is read from: its own, and that of its shape. None of them may be
/// replaced by a result. Throws like read_config() when the file cannot be read.
std::vector<std::filesystem::path> config_inputs(const std::filesystem::path& file,
                                                 const std::vector<ConfigOverride>& overrides = {});

/// The scenario as TOML text with every key written out; parse_config() of it gives an equal
/// scenario, to the last bit. Throws InvalidInput for a scenario that no configuration can express:
/// a rest curvature about another axis than the second, or a seed above 2^63 - 1.
std::string resolved_config(const Scenario& scenario);

/// The units that a configuration declares in [units], or that a persistence length without them is
/// in. Throws like read_config() when the file cannot be read.
DeclaredUnits declared_units(const std::filesystem::path& file,
                             const std::vector<ConfigOverride>& overrides = {});

/// Paths of the keys that a configuration gives, such as "cavity.radius".
std::vector<std::string> given_keys(const std::filesystem::path& file,
                                    const std::vector<ConfigOverride>& overrides = {});

/// What keeps a run of one scenario from being continued with another: every key that differs, as
/// "section.key: was x, is now y" on lines of their own: those of `given`, then the others, in the
/// order of resolved_config(). Stop limits and [output] may differ.
std::optional<std::string> continuation_conflict(const Scenario& was, const Scenario& now,
                                                 const std::vector<std::string>& given = {});

/// Differences in [minimizer] and [insertion], which say how the next equilibrium is looked for: a
/// run that has found none may go on with other values.
std::vector<std::string> search_changes(const Scenario& was, const Scenario& now);

}  // namespace wirepack
