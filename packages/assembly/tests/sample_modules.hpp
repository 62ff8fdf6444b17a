#pragma once
// Modules with a known contribution, to see where it goes.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hawser/physics/kernel.hpp"

namespace hawser {

/// Adds the same load at every node of every cell, to every component of every field.
class LoadKernel : public Kernel {
 public:
  LoadKernel(Domain domain, int nodes, std::vector<FieldUse> uses, double load = 0)
      : Kernel(std::move(domain), std::move(uses)), nodes_(nodes), load_(load) {
    for (const FieldUse& use : fields())
      unknowns_ += nodes * use.components;
  }
  int dimension() const override { return 2; }
  int vertices_per_cell() const override { return nodes_; }
  void bind(const CellTabulation& /*table*/) override {}
  CellStatus residual(const CellInput& /*cell*/, double* residual) const override {
    std::fill(residual, residual + unknowns_, load_);
    return CellStatus::ok;
  }
  CellStatus tangent(const CellInput& cell, unsigned /*columns*/, double* residual_,
                     double* tangent) const override {
    std::fill(tangent, tangent + unknowns_ * unknowns_, 0.0);
    return residual(cell, residual_);
  }

 private:
  int nodes_;
  double load_;
  int unknowns_ = 0;
};

inline PhysicsModule module_with(const std::string& name, std::unique_ptr<Kernel> kernel) {
  PhysicsModule module{name, name, {}, {}};
  module.kernels.push_back(std::move(kernel));
  return module;
}

inline FieldUse velocity(Role role) { return StandardFields<2>::velocity.as(role, need::value); }
inline FieldUse displacement(Role role) {
  return StandardFields<2>::displacement.as(role, need::value);
}

}  // namespace hawser
