#pragma once
// Fields, their derivatives and the place at points of cells, on the moved mesh.
#include <vector>

#include "hawser/base/tensor.hpp"
#include "hawser/deck/expression.hpp"
#include "hawser/element/tabulation.hpp"
#include "hawser/fields/dof_map.hpp"
#include "hawser/fields/state.hpp"

namespace hawser {

class FieldSampler {
 public:
  /// Points in the reference cell, of a region's shape, with weights where something is integrated.
  /// `moving`: the field that moves the mesh, or -1. Map and region must outlive this.
  FieldSampler(const DofMap& dofs, const Region& region, Quadrature points,
               const std::vector<int>& fields, int moving);

  const Region& region() const { return region_; }
  const Quadrature& points() const { return points_; }

  /// Goes to a cell of the region, then to a point of it.
  void enter(LocalIndex cell, const State& state);
  void go_to(int point);

  const SpaceTime& place() const { return place_; }
  /// Length, area or volume per that of the reference cell.
  double stretch() const;
  /// dx of a step d xi in the reference cell, m.
  Vector<double, 3> moved(const double* dxi) const;
  /// Of the field fields[k]; 0 from nodes where it is not solved for.
  double value(std::size_t k, int component) const;
  /// Whether all of that field is there in the cell.
  bool lives_here(std::size_t k) const { return fields_[k].lives; }
  /// By the moved position x, y or z; on cells that fill the space.
  double derivative(std::size_t k, int component, int along) const;

 private:
  struct Field {
    int index;
    std::size_t components;
    Tabulation shapes;
    std::vector<double> values;  // [node][component]
    bool lives = true;
  };
  void gather(Field& field, LocalIndex cell, const State& state);

  const DofMap& dofs_;
  const Region& region_;
  Quadrature points_;
  Tabulation geometry_;
  std::vector<Field> fields_;
  int moving_;
  std::vector<LocalIndex> rows_;
  std::vector<double> reference_, moved_;  // of the nodes that move the cell, [node][3], m
  std::size_t point_ = 0;
  SpaceTime place_;
  Tensor<double, 3> jacobian_;  // (j, k) = d x_j / d xi_k; the identity beyond the cell's dimension
  Tensor<double, 3> inverse_;   // (k, j) = d xi_k / d x_j
};

/// Whether a field is solved for at all nodes of a region's cells. Collective.
bool lives_throughout(const DofMap& dofs, int field, const Region& region);

}  // namespace hawser
