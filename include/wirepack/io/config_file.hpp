#pragma once

#include <filesystem>
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

/// What a configuration says.
struct Configuration {
  Scenario scenario;
  DeclaredUnits units;                  ///< of [units], or of a persistence length without them
  std::vector<std::string> given_keys;  ///< paths, such as "cavity.radius"
  std::vector<std::filesystem::path> inputs;  ///< its file and that of its shape
};

/// A TOML configuration. Keys that are not given take the values of default_scenario() for the
/// given setup, cavity.radius, wire.radius and wire.youngs_modulus, which may be given as
/// stiffnesses, a persistence length or a wound coil (data/docs/stiffness.md); insertion.increment
/// follows a given wire.edge_length; any given stop limit replaces the default one.
/// wire.precurvature = k is the rest shape (0, k, 0). wire.reference_shape takes its place: the
/// name of a shape file (shape_file.hpp), relative to the folder of `source`, or to that of an
/// override; or its rows.
///
/// Throws InvalidInput with one line per problem, "file:line:column: section.key = value: what is
/// allowed", for all problems at once: syntax, unknown sections and keys, wrong types, impossible
/// values, a file without any key. `source` names the text in messages.
Configuration parse_configuration(std::string_view text, const std::string& source,
                                  const std::vector<ConfigOverride>& overrides = {});

/// parse_configuration() of a file. Throws InvalidInput also when the file is missing, is not a
/// regular text file, or is larger than 1 MB; FileError when reading it fails.
Configuration read_configuration(const std::filesystem::path& file,
                                 const std::vector<ConfigOverride>& overrides = {});

/// The scenarios of these alone.
Scenario parse_config(std::string_view text, const std::string& source,
                      const std::vector<ConfigOverride>& overrides = {});
Scenario read_config(const std::filesystem::path& file,
                     const std::vector<ConfigOverride>& overrides = {});

/// The scenario as TOML text with every key written out, and the units if there are any;
/// parse_configuration() of it gives an equal scenario, to the last bit. Throws InvalidInput for a
/// scenario that no configuration can express: a rest curvature about another axis than the second,
/// or a seed above 2^63 - 1.
std::string resolved_config(const Scenario& scenario, const DeclaredUnits& units = {});

}  // namespace wirepack
