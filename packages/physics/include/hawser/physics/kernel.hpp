#pragma once
// The residual of one module on the cells of one domain, and its exact derivative.
//
// A cell's unknowns are ordered field by field (in the order of fields()), then node by node, then
// by component. All arrays are plain; one virtual call per cell, none per quadrature point.
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "hawser/base/domain.hpp"
#include "hawser/deck/location.hpp"
#include "hawser/element/tabulation.hpp"
#include "hawser/physics/cell_input.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/physics/kernel_properties.hpp"

namespace hawser {

enum class CellStatus {
  ok,
  inverted,   ///< det F <= 0
  not_finite  ///< the residual is not a number
};

/// A term of the energy balance. Terms of one name and kind are one term of the run.
struct EnergyTerm {
  enum class Kind {
    stored,       ///< kinetic, strain: the power is the rate of the energy
    supplied,     ///< by loads
    dissipated,   ///< by what the equations describe
    numerical,    ///< by what the discretisation in space adds to them
    transported,  ///< carried out of the region
  };
  const char* name;  ///< with spaces: it becomes part of a quantity's name
  Kind kind;
};

class Kernel {
 public:
  /// `constants`: values of the properties that the module gives itself, nothing: of none.
  Kernel(Domain domain, std::vector<FieldUse> fields, std::vector<PropertyUse> properties = {},
         std::vector<PropertyConstant> constants = {})
      : domain_(std::move(domain)),
        fields_(std::move(fields)),
        properties_(std::move(properties), std::move(constants)) {}
  virtual ~Kernel() = default;
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  const Domain& domain() const { return domain_; }
  /// Its own, then those that only the sources of its properties read.
  const std::vector<FieldUse>& fields() const { return fields_; }
  const KernelProperties& properties() const { return properties_; }
  /// Before bind(): `source` supplies that property on the cells of `on`.
  void connect(std::size_t property, const Supply& supply) {
    properties_.connect(property, supply, fields_);
  }
  virtual int dimension() const = 0;                  ///< of the mesh that it is written for
  virtual std::vector<CellShape> shapes() const = 0;  ///< of the cells that it is written for
  /// The field whose value is the rate of field `field` on structures; -1 when it follows none or
  /// one that the kernel does not list.
  int rate_partner(std::size_t field) const;

  /// Called once, before the first residual, with the shape functions of every field and of the
  /// cells' geometry; on a line, a point, a patch or a facet there are none.
  /// PluginError when the kernel cannot work with so many.
  virtual void bind(const CellTabulation& table) = 0;
  /// Of a field on one cell, once bound.
  virtual int nodes(std::size_t field) const = 0;

  /// residual[n]; n is the number of the cell's unknowns. Overwrites.
  virtual CellStatus residual(const CellInput& cell, double* residual) const = 0;

  /// Also the tangent [n][n], row by row, d residual_i / d unknown_j with all rates following their
  /// values. Overwrites.
  virtual CellStatus tangent(const CellInput& cell, double* residual, double* tangent) const = 0;

  /// How many doubles each cell remembers from one accepted step to the next, such as a plastic
  /// strain at every quadrature point. They are kept for the kernel, written to checkpoints and
  /// untouched by a step that is rejected. At the start of a run they are zero.
  virtual int memory_per_cell() const { return 0; }
  /// What is to be remembered of an accepted step, `next`, from its state and what was remembered
  /// before, cell.memory. Evaluated once per step and cell, on every rank that holds the cell.
  virtual void advance_memory(const CellInput& /*cell*/, double* /*next*/) const {}
  /// Whether the law switches between branches, as slack and contact do. Newton's method then
  /// solves first with the branch of the accepted state held for all values, where that is a
  /// smoother law, and the law itself takes over in the cells whose solution is on another branch.
  virtual bool switches() const { return false; }
  /// Whether the law itself has this cell's residual: else the branch held is the wrong one.
  virtual bool on_held_branch(const CellInput& /*cell*/) const { return true; }

  /// What else the cell can tell for output, such as a tension; evaluate() gives one value for
  /// each.
  struct Quantity {
    std::string name;
    std::string unit;
    bool per_depth = false;  ///< a force, say: per metre of depth where the mesh is a plane body's
  };
  virtual std::vector<Quantity> quantities() const { return {}; }
  virtual void evaluate(const CellInput& /*cell*/, double* /*values*/) const {}

  /// What becomes of the power residual . velocity on the velocity's rows; the balance counts as
  /// unexplained what the terms leave of it. Where a kernel has no such rows it has no terms.
  virtual std::vector<EnergyTerm> energy_terms() const { return {}; }
  /// One value per term at the instant of the equations, W: together (supplied ones negative)
  /// residual . velocity.
  virtual void powers(const CellInput& /*cell*/, double* /*powers*/) const {}
  /// One value per term, J, at the state's own instant; only those of stored terms are looked at.
  virtual void energies(const CellInput& /*cell*/, double* /*energies*/) const {}

  /// An admissible state for derivative checks: det F > 0, away from kinks. Amplitudes per field.
  virtual std::vector<double> sample_amplitudes() const;

 protected:
  KernelProperties& own_properties() { return properties_; }
  /// For a field that a deck names.
  void name_field(std::size_t field, const std::string& name, const std::string& unit,
                  const std::string& residual_unit) {
    const auto kept = [this](const std::string& text) {
      names_.push_back(text);
      return names_.back().c_str();
    };
    fields_[field].name = kept(name);
    fields_[field].unit = kept(unit);
    fields_[field].residual_unit = kept(residual_unit);
  }

 private:
  Domain domain_;
  std::vector<FieldUse> fields_;
  std::list<std::string> names_;  // of fields that a deck names
  KernelProperties properties_;
};

/// A module as the rest of the program sees it: its kernels, the named block its rows belong to,
/// and the properties that it supplies to itself and to others.
struct PhysicsModule {
  std::string name;
  std::string block;  ///< fluid, structure, mesh or a name of its own
  std::vector<std::unique_ptr<Kernel>> kernels;
  Location location{};   ///< of its element in the deck, for complaints that need the mesh
  std::string plugin{};  ///< that it comes from; empty for what is built in
  std::vector<Supply> supplies{};
};

/// "module 'heat' of plug-in 'warmth'".
inline std::string named(const PhysicsModule& module) {
  return "module '" + module.name + "'" +
         (module.plugin.empty() ? "" : " of plug-in '" + module.plugin + "'");
}

}  // namespace hawser
