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
  LoadKernel(Domain domain, CellShape shape, std::vector<FieldUse> uses, double load = 0)
      : Kernel(std::move(domain), std::move(uses)), shape_(shape), load_(load) {}
  int dimension() const override { return 2; }
  std::vector<CellShape> shapes() const override { return {shape_}; }
  void bind(const CellTabulation& table) override {
    nodes_.clear();
    unknowns_ = 0;
    for (std::size_t f = 0; f < fields().size(); ++f) {
      nodes_.push_back(f < table.fields.size() ? table.fields[f].nodes : vertices());
      unknowns_ += nodes_[f] * fields()[f].components;
    }
  }
  int nodes(std::size_t field) const override { return nodes_[field]; }
  CellStatus residual(const CellInput& /*cell*/, double* residual) const override {
    std::fill(residual, residual + unknowns_, load_);
    return CellStatus::ok;
  }
  CellStatus tangent(const CellInput& cell, double* residual_, double* tangent) const override {
    std::fill(tangent, tangent + unknowns_ * unknowns_, 0.0);
    return residual(cell, residual_);
  }

 private:
  int vertices() const {
    return domain().kind == Domain::Kind::patches ? 3 : traits(shape_).vertices;
  }

  CellShape shape_;
  std::vector<int> nodes_;
  double load_;
  int unknowns_ = 0;
};

/// Adds nothing; every cell remembers how much time went by and the sum of its accepted values.
class RememberingKernel : public LoadKernel {
 public:
  using LoadKernel::LoadKernel;
  int memory_per_cell() const override { return 2; }
  void advance_memory(const CellInput& cell, double* next) const override {
    next[0] = cell.memory[0] + cell.elapsed;
    next[1] = cell.memory[1];
    for (int i = 0; i < nodes(0) * fields()[0].components; ++i)
      next[1] += cell.fields[0].value[i];
  }
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
