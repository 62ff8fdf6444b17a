#pragma once
// A quantity that one module supplies at a point and the kernels of others use: a viscosity that
// follows the strain rate, a body force that follows the temperature.
//
// A kernel declares the properties it uses (PropertyUse). Its module gives a constant, or modules
// supply them (Supply); contributions that add are summed. What a source reads becomes a field of
// the kernel that uses it, and its derivatives reach that kernel's tangent: Jacobians stay exact.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/base/domain.hpp"
#include "hawser/deck/diagnostics.hpp"
#include "hawser/element/tabulation.hpp"
#include "hawser/physics/cell_input.hpp"
#include "hawser/physics/field_use.hpp"

namespace hawser {

struct PropertyUse {
  const char* name;  ///< as in decks: "body force"
  const char* unit;
  int components = 1;
  /// Of every component where nobody gives it; nothing: it must be given.
  std::optional<double> otherwise{};
};

/// The properties that shipped modules use or supply.
namespace property {
constexpr PropertyUse density{"density", "kg/m^3"};
constexpr PropertyUse viscosity{"viscosity", "Pa s"};
/// Kinematic: the density of the fluid where it flows is the user's of this one.
constexpr PropertyUse eddy_viscosity{"eddy viscosity", "m^2/s", 1, 0.0};
constexpr PropertyUse mesh_stiffness{"mesh stiffness", "1", 1, 1.0};
template <int D>
constexpr PropertyUse body_force{"body force", "m/s^2", D, 0.0};  ///< per mass
}  // namespace property

/// The law of a property, evaluated at all points of a cell by one call.
class PropertySource {
 public:
  explicit PropertySource(std::vector<FieldUse> fields) : fields_(std::move(fields)) {}
  virtual ~PropertySource() = default;
  PropertySource& operator=(const PropertySource&) = delete;

  const std::vector<FieldUse>& fields() const { return fields_; }  ///< all of them only read
  virtual int dimension() const = 0;
  /// An empty unit is that of whoever uses it.
  virtual PropertyUse property() const = 0;
  /// Every user has a copy: each is bound to other points.
  virtual std::unique_ptr<PropertySource> clone() const = 0;

  /// Once, before fields() is looked at: the fields of the run, for a law that a deck gives in
  /// fields by name.
  virtual void resolve(const std::vector<FieldUse>& /*run*/, Diagnostics& /*diagnostics*/) {}
  /// Of numbers that a deck gives with a unit, against that of whoever uses the property.
  virtual void check_unit(const char* /*wanted*/, Diagnostics& /*diagnostics*/) const {}
  /// Once, with the shapes of fields() at the points where the property is wanted.
  virtual void bind(const CellTabulation& table) = 0;
  /// `cell.fields` in the order of fields(). values[point][component]; slopes, unless null,
  /// [point][component][unknown] by the cell's unknowns, field by field, node by node, component by
  /// component, rates following their values. Overwrites. False where det F <= 0.
  virtual bool evaluate(const CellInput& cell, double* values, double* slopes) const = 0;

 protected:
  PropertySource(const PropertySource&) = default;
  void set_fields(std::vector<FieldUse> fields) { fields_ = std::move(fields); }

 private:
  std::vector<FieldUse> fields_;
};

/// What a module supplies, and where.
struct Supply {
  Domain on;  ///< cells of the body
  /// Its values are added to those of other suppliers; else it must be the only one.
  bool adds = true;
  std::unique_ptr<PropertySource> source;
};

}  // namespace hawser
