#pragma once
// What a module declares about the fields it touches. Block structure, sparsity and the
// off-diagonal Jacobian blocks follow from these declarations.
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "hawser/element/basis.hpp"

namespace hawser {

enum class Role {
  reads,            ///< enters the residual of other fields only; some module must solve for it
  reads_if_solved,  ///< the same, and zero where no module solves for it
  adds,             ///< contributes to the field's rows; contributions of several modules add up
  governs,   ///< the field's rows are this module's alone, unless a structure or a condition takes
             ///< them
  kinematic  ///< a structure's displacement: its rows are the time scheme's relation to the
             ///< velocity
};

constexpr bool only_reads(Role role) {
  return role == Role::reads || role == Role::reads_if_solved;
}
constexpr bool has_rows(Role role) { return role == Role::adds || role == Role::governs; }

enum class RateRule {
  none,     ///< the field has no rate
  dynamic,  ///< the time scheme's rate of a first-order unknown (velocity, temperature)
  quotient  ///< a moving geometry: second-order difference quotient; on structures the velocity
            ///< itself
};

namespace need {
constexpr unsigned value = 1, gradient = 2, rate = 4, accepted = 8;
}

/// Basis and numbering are the run's, agreed upon by all modules and the deck: here stand wishes.
/// A kernel learns from bind() what it got.
struct FieldUse {
  const char* name;
  const char* unit;
  const char* residual_unit;  ///< of the rows' entries, per metre of depth in two dimensions
  int components;
  RateRule rate_rule;
  Role role = Role::reads;
  unsigned needs = need::value;  ///< which of value, gradient, rate, accepted the residual looks at
  /// On a structure's nodes the field's rate is the value of this one (a displacement's: the
  /// velocity).
  const char* follows = nullptr;
  std::optional<Basis> basis{};          ///< P1 where nobody wishes otherwise
  bool needs_basis = false;              ///< the residual is right with that basis alone
  std::optional<Numbering> numbering{};  ///< continuous where nobody wishes otherwise
  /// A constant added everywhere changes nothing but what boundaries take up: a pressure's level.
  /// What it contributes to a balance is no scale for that balance.
  bool has_level = false;
  /// Its values are places: how far they are off is judged against the size of the cells.
  bool places_nodes = false;

  constexpr FieldUse as(Role new_role, unsigned new_needs) const {
    FieldUse copy = *this;
    copy.role = new_role;
    copy.needs = new_needs;
    return copy;
  }
  /// Only its differences count.
  constexpr FieldUse with_level() const {
    FieldUse copy = *this;
    copy.has_level = true;
    return copy;
  }
  constexpr FieldUse of_places() const {
    FieldUse copy = *this;
    copy.places_nodes = true;
    return copy;
  }
  constexpr FieldUse wishing(Basis wish) const { return with(wish, false); }
  constexpr FieldUse only(Basis wish) const { return with(wish, true); }
  constexpr FieldUse wishing(Numbering wish) const {
    return {name,    unit,  residual_unit, components, rate_rule, role,        needs,
            follows, basis, needs_basis,   wish,       has_level, places_nodes};
  }

  constexpr FieldUse with(Basis wish, bool needed) const {
    return {name,    unit, residual_unit, components, rate_rule, role,        needs,
            follows, wish, needed,        numbering,  has_level, places_nodes};
  }
};

/// Index in `uses` of the field that `field` follows; -1 when it follows none of them.
constexpr int rate_partner(const FieldUse* uses, std::size_t count, std::size_t field) {
  const char* const wanted = uses[field].follows;
  if (wanted == nullptr) return -1;
  for (std::size_t f = 0; f < count; ++f)
    if (std::string_view(uses[f].name) == wanted) return static_cast<int>(f);
  return -1;
}

template <std::size_t N>
constexpr std::array<int, N> rate_partners(const std::array<FieldUse, N>& uses) {
  std::array<int, N> partners{};
  for (std::size_t f = 0; f < N; ++f)
    partners[f] = rate_partner(uses.data(), N, f);
  return partners;
}

namespace field_name {
constexpr const char* velocity = "velocity";
constexpr const char* pressure = "pressure";
constexpr const char* displacement = "displacement";  ///< the one field that moves the mesh
}  // namespace field_name

/// Fields that several modules share, in D dimensions.
template <int D>
struct StandardFields {
  static constexpr const char* force = D == 2 ? "N/m" : "N";
  static constexpr FieldUse velocity{field_name::velocity, "m/s", force, D, RateRule::dynamic};
  static constexpr FieldUse pressure =
      FieldUse{field_name::pressure, "Pa", "m^2/s", 1, RateRule::none}
          .wishing(Numbering::sides)
          .with_level();
  static constexpr FieldUse temperature{"temperature", "K", D == 2 ? "W/m" : "W", 1,
                                        RateRule::dynamic};
  static constexpr FieldUse displacement =
      FieldUse{field_name::displacement, "m",         "m",         D,
               RateRule::quotient,       Role::reads, need::value, field_name::velocity}
          .of_places();
};

}  // namespace hawser
