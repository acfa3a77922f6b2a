#include "wirepack/io/config_file.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "wirepack/core/error.hpp"
#include "wirepack/io/continuation.hpp"
#include "wirepack/rod/elasticity.hpp"

namespace wirepack {
namespace {

Scenario parsed(const std::string& text, const std::vector<ConfigOverride>& overrides = {}) {
  return parse_config(text, "test.toml", overrides);
}

std::string message_of(const std::string& text, const std::vector<ConfigOverride>& overrides = {}) {
  try {
    parsed(text, overrides);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "no error";
}

TEST(ConfigFile, radius_alone_gives_the_run_of_the_paper) {
  const Scenario s = parsed("[cavity]\nradius = 20\n");
  const Scenario expected = default_scenario(Setup::low_torsion, Cavity{20});
  EXPECT_EQ(resolved_config(s), resolved_config(expected));
  EXPECT_EQ(s.stop.scaled_force, 10);
}

TEST(ConfigFile, setup_sets_twist_and_precurvature_unless_they_are_given) {
  const std::string high = "[packing]\nsetup = 'high_torsion'\n[cavity]\nradius = 8\n";
  EXPECT_EQ(parsed(high).nozzle.twist, TwistCondition::locked);
  EXPECT_EQ(parsed(high).wire.rest_darboux, Vec3(0, 1.0 / 16, 0));
  const Scenario given = parsed(high + "[nozzle]\ntwist = 'free'\n[wire]\nprecurvature = 0.01\n");
  EXPECT_EQ(given.nozzle.twist, TwistCondition::free);
  EXPECT_EQ(given.wire.rest_darboux, Vec3(0, 0.01, 0));
}

TEST(ConfigFile, defaults_follow_the_values_they_depend_on) {
  const Scenario s = parsed("[wire]\nradius = 0.5\nyoungs_modulus = 7\nedge_length = 0.3\n");
  EXPECT_EQ(s.wall_stiffness, 7);
  EXPECT_EQ(s.contact.stiffness, 7);
  EXPECT_DOUBLE_EQ(s.contact.excluded_arc_length, pi / 2);
  EXPECT_EQ(s.insertion.increment, 0.15);
  EXPECT_EQ(parsed("[wire]\nedge_length = 0.8\n[insertion]\nincrement = 0.2").insertion.increment,
            0.2);
}

TEST(ConfigFile, a_given_limit_replaces_the_default_limit) {
  const Scenario s = parsed("[stop]\nlength = 30\nincrements = 7\n");
  EXPECT_FALSE(s.stop.scaled_force);
  EXPECT_EQ(s.stop.length, 30);
  EXPECT_EQ(s.stop.increments, 7);
}

TEST(ConfigFile, the_resolved_text_gives_an_equal_scenario) {
  Scenario s = default_scenario(Setup::high_torsion, Cavity{17.0 / 3}, 0.1 + 0.2, 1e7 / 3);
  s.seed = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  s.wire.poisson_ratio = -0.1;
  s.contact_enabled = false;
  s.stop = StopLimits{};
  s.stop.force = 1e-3 / 7;
  s.stop.length = 1e22;
  s.stop.increments = 123456789012;
  s.minimizer = {1.0 / 3e5, 77, 9, 11, 5e-324, DescentMethod::compact_lbfgs};
  s.output.frame_every_density = 1e-300 / 3;
  const Scenario back = parsed(resolved_config(s));
  EXPECT_EQ(back.setup, s.setup);
  EXPECT_EQ(back.seed, s.seed);
  EXPECT_EQ(back.wire.radius, s.wire.radius);
  EXPECT_EQ(back.wire.youngs_modulus, s.wire.youngs_modulus);
  EXPECT_EQ(back.wire.poisson_ratio, s.wire.poisson_ratio);
  EXPECT_EQ(back.wire.stretch_multiplier, s.wire.stretch_multiplier);
  EXPECT_EQ(back.wire.edge_length, s.wire.edge_length);
  EXPECT_EQ(back.wire.rest_darboux, s.wire.rest_darboux);
  EXPECT_EQ(back.cavity.radius, s.cavity.radius);
  EXPECT_EQ(back.wall_stiffness, s.wall_stiffness);
  EXPECT_EQ(back.nozzle.twist, s.nozzle.twist);
  EXPECT_EQ(back.contact_enabled, s.contact_enabled);
  EXPECT_EQ(back.contact.stiffness, s.contact.stiffness);
  EXPECT_EQ(back.contact.excluded_arc_length, s.contact.excluded_arc_length);
  EXPECT_EQ(back.insertion.increment, s.insertion.increment);
  EXPECT_EQ(back.insertion.perturbation, s.insertion.perturbation);
  EXPECT_EQ(back.stop.scaled_force, s.stop.scaled_force);
  EXPECT_EQ(back.stop.force, s.stop.force);
  EXPECT_EQ(back.stop.density, s.stop.density);
  EXPECT_EQ(back.stop.length, s.stop.length);
  EXPECT_EQ(back.stop.increments, s.stop.increments);
  EXPECT_EQ(back.minimizer.tolerance, s.minimizer.tolerance);
  EXPECT_EQ(back.minimizer.max_evaluations, s.minimizer.max_evaluations);
  EXPECT_EQ(back.minimizer.memory, s.minimizer.memory);
  EXPECT_EQ(back.minimizer.refactor_every, s.minimizer.refactor_every);
  EXPECT_EQ(back.minimizer.shift, s.minimizer.shift);
  EXPECT_EQ(back.minimizer.method, s.minimizer.method);
  EXPECT_EQ(back.output.frame_every_density, s.output.frame_every_density);
  EXPECT_EQ(back.output.checkpoint_every_seconds, s.output.checkpoint_every_seconds);
}

TEST(ConfigFile, a_reference_shape_is_kept_to_the_last_bit_and_takes_the_place_of_precurvature) {
  const Scenario s = parsed(
      "[packing]\nsetup = 'high_torsion'\n[wire]\nreference_shape_beyond = 'repeat'\n"
      "reference_shape = [[0, 0.1, 0.2, 0.3], [1.1, 1e-3, -0.25, 0.7]]\n");
  EXPECT_TRUE(s.wire.rest_darboux.isZero());
  EXPECT_EQ(s.nozzle.twist, TwistCondition::locked);
  Scenario odd = s;
  odd.wire.reference_shape.table =
      DarbouxTable({{0, Vec3(1.0 / 3, -1e-300 / 7, 0.1 + 0.2)}, {22.0 / 7, Vec3::Zero()}});
  const Scenario back = parsed(resolved_config(odd));
  EXPECT_EQ(back.wire.reference_shape.table, odd.wire.reference_shape.table);
  EXPECT_EQ(back.wire.reference_shape.beyond, BeyondShape::repeat);
  EXPECT_EQ(continuation_conflict(s, odd), "wire.reference_shape: is another one than it was");
}

TEST(ConfigFile, scenarios_that_have_no_text_are_refused) {
  Scenario s = default_scenario(Setup::low_torsion, Cavity{10});
  s.wire.rest_darboux = Vec3(0.1, 0, 0);
  EXPECT_THROW(resolved_config(s), InvalidInput);
  s.wire.rest_darboux = Vec3::Zero();
  s.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_THROW(resolved_config(s), InvalidInput);
}

TEST(ConfigFile, overrides_replace_add_and_are_named_in_messages) {
  const std::string text = "[cavity]\nradius = 5\n";
  EXPECT_EQ(parsed(text, {{"cavity.radius=6.5", "--set"}}).cavity.radius, 6.5);
  EXPECT_EQ(parsed(text, {{"packing.setup=high_torsion", "--set"}}).setup, Setup::high_torsion);
  EXPECT_EQ(parsed(text, {{"packing.setup=\"high_torsion\"", "--set"}}).setup, Setup::high_torsion);
  EXPECT_EQ(parsed(text, {{"stop.force=1", "a"}, {"stop.force=2", "b"}}).stop.force, 2);
  EXPECT_EQ(message_of(text, {{"cavity.radius=-1", "--set cavity.radius=-1"}}),
            "--set cavity.radius=-1: cavity.radius = -1: must be positive and finite");
  // the file's own value is wrong, but the run does not use it
  EXPECT_EQ(parsed("[cavity]\nradius = 'x'\n", {{"cavity.radius=6", "--set"}}).cavity.radius, 6);
}

TEST(ConfigFile, a_problem_of_a_default_is_reported_only_on_its_own) {
  EXPECT_EQ(message_of("[cavity]\nradius = -5\n"),
            "test.toml:2:1: cavity.radius = -5: must be positive and finite");
  EXPECT_EQ(message_of("[wire]\nedge_length = -1\n"),
            "test.toml:2:1: wire.edge_length = -1: must be positive and finite");
}

TEST(ConfigFile, only_limits_and_output_may_change_in_a_continuation) {
  const Scenario was = parsed("[cavity]\nradius = 5\n");
  EXPECT_FALSE(continuation_conflict(was, parsed("[cavity]\nradius = 5\n[stop]\nlength = 3\n"
                                                 "[output]\nframe_every_density = 0.5\n")));
  EXPECT_EQ(continuation_conflict(was, parsed("[cavity]\nradius = 5\n[packing]\nseed = 2\n")),
            "packing.seed: was 1, is now 2");
}

double number(const std::string& text, double Stiffness::*member) {
  return stiffness(parsed(text).wire).*member;
}

TEST(ConfigFile, bending_and_torsional_stiffness_give_the_wire_that_has_them) {
  const std::string text = "[wire]\nradius = 0.5\nbending_stiffness = 205\n";
  EXPECT_NEAR(number(text, &Stiffness::bend), 205, 1e-10);
  EXPECT_EQ(parsed(text).wire.poisson_ratio, RodParams{}.poisson_ratio);
  EXPECT_NEAR(number(text + "torsional_stiffness = 410", &Stiffness::twist), 410, 1e-10);
  EXPECT_NEAR(number(text + "torsional_stiffness = 20.5", &Stiffness::twist), 20.5, 1e-4);
  EXPECT_NEAR(number(text + "poisson_ratio = 0.25", &Stiffness::twist), 205 / 1.25, 1e-10);
  const Scenario s = parsed(text);
  EXPECT_EQ(s.wall_stiffness, s.wire.youngs_modulus);
  EXPECT_EQ(s.contact.stiffness, s.wire.youngs_modulus);
  EXPECT_EQ(resolved_config(parsed(resolved_config(s))), resolved_config(s));
}

TEST(ConfigFile, units_are_written_and_read_back_and_change_no_number) {
  const std::string text = "[cavity]\nradius = 8\n[units]\nlength = 'mm'\nforce = 'mN'\n";
  const Configuration given = parse_configuration(text, "test.toml");
  const std::string written = resolved_config(given.scenario, given.units);
  const Configuration back = parse_configuration(written, "again.toml");
  EXPECT_EQ(back.units.length, "mm");
  EXPECT_EQ(back.units.force, "mN");
  EXPECT_EQ(resolved_config(back.scenario), resolved_config(parsed("[cavity]\nradius = 8")));
  const Configuration molecule =
      parse_configuration("[wire]\npersistence_length = 50\ntemperature = 300\n", "test.toml");
  EXPECT_EQ(molecule.units.length, "nm");
  const Configuration resolved =
      parse_configuration(resolved_config(molecule.scenario, molecule.units), "again.toml");
  EXPECT_EQ(resolved.units.force, "pN");
  EXPECT_EQ(resolved_config(resolved.scenario), resolved_config(molecule.scenario));
}

TEST(ConfigFile, a_persistence_length_is_k_B_T_over_bending_stiffness_in_the_declared_units) {
  const std::string keys = "[wire]\npersistence_length = 50\ntemperature = 300\n";
  EXPECT_NEAR(number(keys, &Stiffness::bend), 207.097, 1e-3);  // pN nm^2
  EXPECT_NEAR(number(keys + "[units]\nlength = 'nm'\nforce = 'pN'", &Stiffness::bend), 207.097,
              1e-3);
  EXPECT_NEAR(number(keys + "[units]\nlength = 'nm'\nforce = 'nN'", &Stiffness::bend), 0.207097,
              1e-6);
  const std::string metres =
      "[wire]\nradius = 1e-9\npersistence_length = 50e-9\ntemperature = 300\n"
      "[cavity]\nradius = 27e-9\n";
  EXPECT_NE(message_of(metres).find("give `length = \"m\"`"), std::string::npos);
  EXPECT_NEAR(number(metres + "[units]\nlength = 'm'\nforce = 'N'", &Stiffness::bend), 2.07097e-28,
              1e-33);
}

TEST(ConfigFile, a_wound_coil_is_a_wire_of_its_radius_with_its_stiffnesses) {
  const std::string text =
      "[wire]\n[wire.coil]\nwire_diameter = 0.05\ncoil_diameter = 0.35\nyoungs_modulus = 70\n"
      "[cavity]\nradius = 3\n";
  const Scenario s = parsed(text);
  const Stiffness expected = stiffness(WoundCoil{0.05, 0.35, 70, 0.3});
  EXPECT_EQ(s.wire.radius, 0.175);
  EXPECT_NEAR(stiffness(s.wire).bend / expected.bend, 1, 1e-12);
  EXPECT_NEAR(stiffness(s.wire).twist / expected.twist, 1, 1e-12);
  EXPECT_NEAR(stiffness(s.wire).stretch / expected.stretch, 1, 1e-12);
  EXPECT_EQ(parsed(text, {{"wire.coil.poisson_ratio=0.1", "--set"}}).wire.poisson_ratio < 0, true);
  EXPECT_EQ(parsed(text, {{"wire.stretch_multiplier=2", "--set"}}).wire.stretch_multiplier, 2);
}

TEST(ConfigFile, stiffnesses_that_say_the_same_twice_or_cannot_be_are_refused) {
  const auto refused = [](const std::string& keys, const std::string& part) {
    const std::string message = message_of("[wire]\n" + keys);
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  };
  refused("bending_stiffness = 2\nyoungs_modulus = 5",
          ":2:1: wire.bending_stiffness = 2: wire.youngs_modulus is given, too");
  refused("bending_stiffness = -2", ":2:1: wire.bending_stiffness = -2: must be positive");
  refused("bending_stiffness = 2\ntorsional_stiffness = 1e-6",
          "must be between 1e-06 and 1e+06 times the bending stiffness, 2");
  refused("torsional_stiffness = 1", "needs wire.bending_stiffness beside it");
  refused("persistence_length = 50", "needs wire.temperature beside it");
  refused("temperature = 300", "needs wire.persistence_length beside it");
  refused("[wire.coil]\nwire_diameter = 0.05\nyoungs_modulus = 5",
          "needs wire.coil.coil_diameter beside it");
  refused("[wire.coil]\nwire_diameter = 0.05\ncoil_diameter = 0.1\nyoungs_modulus = 5",
          "must be above two of wire.coil.wire_diameter = 0.05");
  refused(
      "poisson_ratio = 0.2\n[wire.coil]\nwire_diameter = 0.05\ncoil_diameter = 0.35\n"
      "youngs_modulus = 5",
      "[wire.coil] is given, too");
  refused(
      "radius = 0.1\n[wire.coil]\nwire_diameter = 0.05\ncoil_diameter = 0.35\n"
      "youngs_modulus = 5",
      "must be at least half of wire.coil.coil_diameter, 0.175");
  refused("radius = [1.0, 0.8]", "sections of it are not read");
  refused("coil = 3", "is a section; its keys go below [wire.coil]");
  refused("[wire.coyl]\nwire_diameter = 3", "did you mean wire.coil?");
  refused("[units]\nlength = 'mm'", "length and force are declared together");
  refused("[units]\nlength = 'inch'\nforce = 'N'", "must be \"m\" or");
}

TEST(ConfigFile, overrides_may_have_blanks_and_words_that_were_meant_as_numbers_are_explained) {
  const std::string text = "[cavity]\nradius = 5\n";
  EXPECT_EQ(parsed(text, {{" cavity.radius = 6.5 ", "--set"}}).cavity.radius, 6.5);
  const auto hint = [&](const std::string& value) {
    return message_of(text, {{"stop.density=" + value, "--set"}});
  };
  EXPECT_NE(hint(".2").find("must be a finite number; write 0.2"), std::string::npos);
  EXPECT_NE(hint("20%").find("; write 0.2 (a number has no percent sign)"), std::string::npos);
  EXPECT_NE(hint("0,2").find("; write 0.2 (decimals follow a point)"), std::string::npos);
  EXPECT_EQ(hint("dense").find("write"), std::string::npos);
}

TEST(ConfigFile, slips_of_toml_are_told_by_what_was_meant) {
  const auto told = [](const std::string& text, const std::string& part) {
    EXPECT_NE(message_of(text).find(part), std::string::npos) << text << ": " << message_of(text);
  };
  told("[packing]\nsetup = low_torsion\n", "words are in quotes; write \"low_torsion\"");
  told("[cavity]\nradius = 5 mm\n", "write 5 (a number has no unit behind it)");
  told("[cavity]\nradius = 1mm\n", "write 1 (a number has no unit behind it)");
  told("[cavity]\nradius = 10 # in \xb5m\n", "is not UTF-8");
  told("[cavity]\nradius = 10\n[[stop]]\ndensity = 0.1\n", "[[stop]]: there is one of them");
  told("[cavity]\nradius = 10\n[[wire]]\nradius = 1\n", "several wires are not possible");
  told("[shape]\nmodel = \"helix\"\nk0 = []\n", "for wire.reference_shape");
}

TEST(ConfigFile, an_ellipsoid_has_semi_axes_in_place_of_a_radius) {
  const std::string text = "[cavity]\nshape = 'ellipsoid'\nsemi_axes = [12, 10, 9.0]\n";
  const Scenario scenario = parsed(text);
  EXPECT_EQ(*scenario.cavity.semi_axes, Vec3(12, 10, 9));
  EXPECT_NEAR(scenario.cavity.radius, std::cbrt(12.0 * 10 * 9), 1e-13);
  EXPECT_NEAR(scenario.wire.edge_length, scenario.cavity.radius / 10, 1e-13);
  const Scenario again = parsed(resolved_config(scenario));
  EXPECT_EQ(*again.cavity.semi_axes, *scenario.cavity.semi_axes);
  EXPECT_EQ(again.cavity.radius, scenario.cavity.radius);
  const auto refused = [](const std::string& keys, const std::string& part) {
    EXPECT_NE(message_of("[cavity]\n" + keys).find(part), std::string::npos) << keys;
  };
  refused("semi_axes = [1, 1, 1]", "is for cavity.shape = \"ellipsoid\"");
  EXPECT_EQ(message_of("[cavity]\nshape = 'egg'\nsemi_axes = [9, 9, 9]").find('\n'),
            std::string::npos);
  refused("shape = 'ellipsoid'", "needs cavity.semi_axes = [x, y, z]");
  refused("shape = 'ellipsoid'\nradius = 3\nsemi_axes = [9, 9, 9]", "semi_axes in its place");
  refused("shape = 'ellipsoid'\nsemi_axes = [9, 9]", "three finite numbers");
  refused("shape = 'ellipsoid'\nsemi_axes = [9, 9, 4]", "no less than twice wire.radius = 1");
  refused("shape = 'ellipsoid'\nsemi_axes = [9, 9, -9]", "positive and finite");
  refused("shape = 'ellipsoid'\nsemi_axes = [5, 5, 5]\n[wire]\nedge_length = 2.1",
          "must be at most half of the shortest of cavity.semi_axes - wire.radius, 2");
}

TEST(ConfigFile, a_nozzle_may_be_elsewhere_and_point_elsewhere) {
  const std::string text =
      "[cavity]\nradius = 10\n[nozzle]\nposition = [0, 8, 0]\ndirection = [0.5, -1, 0]\ndepth = "
      "0.25\n";
  const NozzleOptions nozzle = parsed(text).nozzle;
  EXPECT_EQ(*nozzle.position, Vec3(0, 8, 0));
  EXPECT_EQ(*nozzle.direction, Vec3(0.5, -1, 0));
  EXPECT_EQ(nozzle.depth, 0.25);
  const NozzleOptions again = parsed(resolved_config(parsed(text))).nozzle;
  EXPECT_EQ(*again.position, *nozzle.position);
  EXPECT_EQ(*again.direction, *nozzle.direction);
  EXPECT_EQ(again.depth, nozzle.depth);
  EXPECT_EQ(resolved_config(parsed("[cavity]\nradius = 10\n")).find("position"), std::string::npos);
  EXPECT_NE(message_of("[cavity]\nradius = 10\n[nozzle]\ndepth = -1\n").find("nozzle.depth = -1"),
            std::string::npos);
}

TEST(ConfigFile, all_differences_of_a_continuation_are_named_those_of_the_users_keys_first) {
  const Scenario was = parsed("[cavity]\nradius = 5\n");
  const Scenario now = parsed("[cavity]\nradius = 8\n");
  const std::string text = *continuation_conflict(was, now, {"cavity.radius"});
  EXPECT_EQ(text.find("cavity.radius: was 5.0, is now 8.0\n  wire.edge_length: was 0.5"), 0U)
      << text;
  EXPECT_NE(text.find("\n  insertion.increment: "), std::string::npos);
  EXPECT_EQ(search_changes(was, now).size(), 1U);  // insertion.increment
}

}  // namespace
}  // namespace wirepack
