#include "wire_stiffness.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string_view>

#include "wirepack/rod/elasticity.hpp"

namespace wirepack {

namespace {

constexpr double largest_poisson_ratio = 0.5;  // of the stock of a coil
// Of twisting stiffness and bending stiffness, either over the other.
constexpr double largest_twist_ratio = 1e6;
// Shorter is no molecule: lengths are in metres, and not in the nm that are taken without units.
constexpr double shortest_persistence = 1e-3;

constexpr std::array<std::string_view, 4> coil_keys{
    "wire.coil.wire_diameter", "wire.coil.coil_diameter", "wire.coil.youngs_modulus",
    "wire.coil.poisson_ratio"};

/// Reads the given numbers and gathers what is wrong with them.
class StiffnessReader {
 public:
  StiffnessReader(GivenNumbers& numbers, DeclaredUnits& units) : numbers_(numbers), units_(units) {}

  std::vector<KeyProblem> resolve() {
    check_company();
    check_signs();
    if (problems_.empty()) {
      if (is_coil()) {
        resolve_coil();
      } else {
        resolve_bending();
        resolve_torsion();
      }
    }
    return std::move(problems_);
  }

 private:
  bool given(std::string_view path) const { return numbers_.find(path) != numbers_.end(); }
  double number(std::string_view path) const { return numbers_.find(path)->second; }
  double radius() const {
    return given("wire.radius") ? number("wire.radius") : RodParams{}.radius;
  }
  bool is_coil() const {
    for (const std::string_view key : coil_keys) {
      if (given(key)) return true;
    }
    return false;
  }

  void complain(std::string_view path, std::string problem) {
    if (given(path)) problems_.push_back({std::string(path), std::move(problem)});
  }

  // Each key beside one that says the same is refused.
  void exclude(std::string_view path, std::string_view other) {
    if (!given(other)) return;
    complain(path, fmt::format("{} is given, too; must be only one of them", other));
  }

  void need(std::string_view path, std::string_view other) {
    if (!given(other)) complain(path, fmt::format("needs {} beside it", other));
  }

  void check_company() {
    exclude("wire.bending_stiffness", "wire.youngs_modulus");
    exclude("wire.persistence_length", "wire.youngs_modulus");
    exclude("wire.persistence_length", "wire.bending_stiffness");
    exclude("wire.torsional_stiffness", "wire.poisson_ratio");
    need("wire.persistence_length", "wire.temperature");
    need("wire.temperature", "wire.persistence_length");
    if (!given("wire.youngs_modulus") && !given("wire.persistence_length")) {
      need("wire.torsional_stiffness", "wire.bending_stiffness");
    }
    if (!is_coil()) return;
    for (const char* path : {"wire.youngs_modulus", "wire.poisson_ratio", "wire.bending_stiffness",
                             "wire.torsional_stiffness", "wire.persistence_length"}) {
      complain(path,
               "[wire.coil] is given, too, which says the stiffness; must be only one of them");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (const std::string_view key : coil_keys) {
        if (given(key) && !given(coil_keys[i])) {
          need(key, coil_keys[i]);
          break;  // one message per missing key
        }
      }
    }
  }

  void check_signs() {
    for (const char* path :
         {"wire.bending_stiffness", "wire.torsional_stiffness", "wire.persistence_length",
          "wire.temperature", "wire.coil.wire_diameter", "wire.coil.coil_diameter",
          "wire.coil.youngs_modulus"}) {
      if (given(path) && !(number(path) > 0)) complain(path, "must be positive");
    }
    if (given("wire.coil.poisson_ratio")) {
      const double ratio = number("wire.coil.poisson_ratio");
      if (!(ratio > -1 && ratio <= largest_poisson_ratio)) {
        complain("wire.coil.poisson_ratio", "must be above -1 and at most 0.5");
      }
    }
    // an impossible radius is reported where all radii are
    impossible_radius_ = !(radius() > 0);
  }

  void resolve_coil() {
    const WoundCoil coil{
        number("wire.coil.wire_diameter"), number("wire.coil.coil_diameter"),
        number("wire.coil.youngs_modulus"),
        given("wire.coil.poisson_ratio") ? number("wire.coil.poisson_ratio") : 0.3};
    const double least = coil.coil_diameter / 2;
    if (!(coil.coil_diameter > 2 * coil.wire_diameter)) {
      complain(
          "wire.coil.coil_diameter",
          fmt::format("is that of the outside; must be above two of wire.coil.wire_diameter = {}",
                      coil.wire_diameter));
      return;
    }
    if (!given("wire.radius")) numbers_["wire.radius"] = least;
    if (!(number("wire.radius") >= least * (1 - 1e-9))) {
      complain("wire.radius", fmt::format("must be at least half of wire.coil.coil_diameter, {}; "
                                          "that is taken where it is not given",
                                          least));
      return;
    }
    const Elasticity solid = elasticity_of(stiffness(coil), number("wire.radius"));
    numbers_["wire.youngs_modulus"] = solid.youngs_modulus;
    numbers_["wire.poisson_ratio"] = solid.poisson_ratio;
    // what is given beside it counts
    numbers_.emplace("wire.stretch_multiplier", solid.stretch_multiplier);
  }

  void resolve_bending() {
    if (impossible_radius_) return;
    std::optional<double> bend;
    if (given("wire.bending_stiffness")) bend = number("wire.bending_stiffness");
    if (given("wire.persistence_length")) {
      const double length = number("wire.persistence_length");
      if (units_.length.empty() && length < shortest_persistence) {
        complain("wire.persistence_length",
                 "is in nm where no units are given, and nothing is so flexible; give `length = "
                 "\"m\"` and `force = \"N\"` in [units]");
        return;
      }
      if (units_.length.empty()) units_ = {"nm", "pN"};
      const auto energy = thermal_energy(number("wire.temperature"), units_);
      if (energy) bend = *energy * length;
    }
    if (!bend) return;
    numbers_["wire.youngs_modulus"] = elasticity_of({*bend, *bend, *bend}, radius()).youngs_modulus;
  }

  void resolve_torsion() {
    if (impossible_radius_ || !given("wire.torsional_stiffness")) return;
    const double twist = number("wire.torsional_stiffness");
    RodParams wire;
    wire.radius = radius();
    wire.youngs_modulus = number("wire.youngs_modulus");
    const double bend = stiffness(wire).bend;
    if (!(twist * largest_twist_ratio >= bend && twist <= bend * largest_twist_ratio)) {
      complain("wire.torsional_stiffness",
               fmt::format("must be between {:.0e} and {:.0e} times the bending stiffness, {:.6g}",
                           1 / largest_twist_ratio, largest_twist_ratio, bend));
      return;
    }
    numbers_["wire.poisson_ratio"] = elasticity_of({bend, bend, twist}, wire.radius).poisson_ratio;
  }

  GivenNumbers& numbers_;
  DeclaredUnits& units_;
  std::vector<KeyProblem> problems_;
  bool impossible_radius_ = false;
};

}  // namespace

std::vector<KeyProblem> resolve_stiffness(GivenNumbers& numbers, DeclaredUnits& units) {
  return StiffnessReader(numbers, units).resolve();
}

}  // namespace wirepack
