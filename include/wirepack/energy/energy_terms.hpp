#pragma once

#include <initializer_list>
#include <string_view>
#include <type_traits>
#include <vector>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Any energy term, by reference: the caller keeps the term alive.
class EnergyTermRef {
 public:
  template <EnergyTerm Term>
  EnergyTermRef(Term& term)
      : term_(const_cast<std::remove_const_t<Term>*>(&term)), calls_(&calls_of<Term>) {}

  std::string_view name() const { return calls_->name; }
  /// Brings up to date what the term keeps about states; false if there was nothing to do.
  bool prepare(const RodState& state) const { return calls_->prepare(term_, state); }
  Energy add_gradient(const RodState& state, Gradient& gradient) const {
    return calls_->add_gradient(term_, state, gradient);
  }
  void add_curvature(const RodState& state, CurvatureModel& model) const {
    calls_->add_curvature(term_, state, model);
  }

 private:
  struct Calls {
    std::string_view name;
    bool (*prepare)(void*, const RodState&);
    Energy (*add_gradient)(const void*, const RodState&, Gradient&);
    void (*add_curvature)(const void*, const RodState&, CurvatureModel&);
  };
  template <class Term>
  static constexpr Calls calls_of{
      Term::name,
      [](void* term, const RodState& state) {
        if constexpr (PreparedTerm<Term>) return static_cast<Term*>(term)->prepare(state);
        return false;
      },
      [](const void* term, const RodState& state, Gradient& gradient) -> Energy {
        return static_cast<const Term*>(term)->add_gradient(state, gradient);
      },
      [](const void* term, const RodState& state, CurvatureModel& model) {
        static_cast<const Term*>(term)->add_curvature(state, model);
      }};

  void* term_;
  const Calls* calls_;
};

/// Energy of one term of a sum.
struct NamedEnergy {
  std::string_view name;
  double energy;
};

/// List of energy terms that add up, and an energy term itself. An optional term is one more entry.
class EnergyTerms {
 public:
  static constexpr std::string_view name = "total";
  EnergyTerms() = default;
  EnergyTerms(std::initializer_list<EnergyTermRef> terms) : terms_(terms) {}
  void add(EnergyTermRef term) { terms_.push_back(term); }
  /// Adds all terms of another list.
  void add(const EnergyTerms& more) {
    terms_.insert(terms_.end(), more.terms_.begin(), more.terms_.end());
  }

  /// Prepares every term; true if one of them had something to do.
  bool prepare(const RodState& state) const;
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;
  /// Energy of each term, in the order of the list; adds the derivatives of all of them.
  std::vector<NamedEnergy> breakdown(const RodState& state, Gradient& gradient) const;

 private:
  std::vector<EnergyTermRef> terms_;
};

}  // namespace wirepack
