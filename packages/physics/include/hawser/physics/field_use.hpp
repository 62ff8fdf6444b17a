#pragma once
// What a module declares about the fields it touches. Block structure, sparsity and the
// off-diagonal Jacobian blocks follow from these declarations.
#include "hawser/element/basis.hpp"

namespace hawser {

enum class Role {
  reads,     ///< enters the residual of other fields only
  adds,      ///< contributes to the field's rows; contributions of several modules add up
  governs,   ///< the field's rows are this module's alone, unless a structure or a condition takes
             ///< them
  kinematic  ///< a structure's displacement: its rows are the time scheme's relation to the
             ///< velocity
};

enum class RateRule {
  none,     ///< the field has no rate
  dynamic,  ///< the time scheme's rate of a first-order unknown (velocity, temperature)
  quotient  ///< a moving geometry: second-order difference quotient; on structures the velocity
            ///< itself
};

namespace need {
constexpr unsigned value = 1, gradient = 2, rate = 4, accepted = 8;
}

struct FieldUse {
  const char* name;
  const char* unit;
  const char* residual_unit;  ///< of the rows' entries, per metre of depth in two dimensions
  int components;
  RateRule rate_rule;
  bool split;  ///< doubled across the slit lines of the mesh
  Role role = Role::reads;
  unsigned needs = need::value;  ///< which of value, gradient, rate, accepted the residual looks at
  Basis basis = Basis::p1;
  /// On a structure's nodes the field's rate is the value of this one (a displacement's: the
  /// velocity).
  const char* follows = nullptr;

  constexpr FieldUse as(Role new_role, unsigned new_needs) const {
    FieldUse copy = *this;
    copy.role = new_role;
    copy.needs = new_needs;
    return copy;
  }
};

namespace field_name {
constexpr const char* velocity = "velocity";
constexpr const char* pressure = "pressure";
constexpr const char* displacement = "displacement";  ///< the one field that moves the mesh
}  // namespace field_name

/// The fields of the towed-cable system in D dimensions.
template <int D>
struct StandardFields {
  static constexpr const char* force = D == 2 ? "N/m" : "N";
  static constexpr FieldUse velocity{field_name::velocity, "m/s", force, D,
                                     RateRule::dynamic,    false};
  static constexpr FieldUse pressure{field_name::pressure, "Pa", "m^2/s", 1, RateRule::none, true};
  static constexpr FieldUse displacement{field_name::displacement,
                                         "m",
                                         "m",
                                         D,
                                         RateRule::quotient,
                                         false,
                                         Role::reads,
                                         need::value,
                                         Basis::p1,
                                         field_name::velocity};
};

}  // namespace hawser
