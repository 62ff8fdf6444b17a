#pragma once
// The map from the reference cell to a cell of the mesh, at one quadrature point after another.
#include <cmath>

#include "hawser/base/tensor.hpp"
#include "hawser/element/tabulation.hpp"

namespace hawser {

/// Of a cell that fills its space of D dimensions. An affine map is inverted once per cell.
template <int D>
struct CellGeometry {
  Vector<double, D> position;          ///< of the point, m
  Tensor<double, D> inverse_jacobian;  ///< (k, j) = d xi_k / d X_j, 1/m
  double determinant = 0;              ///< dX = determinant d xi
  const ShapeTraits* shape = nullptr;

  /// `X`: [node of the map][D], m.
  void enter(const CellTabulation& table, const double* X) {
    shape = &traits(table.rule.shape);
    if (!table.affine) return;
    Tensor<double, D> jacobian;  // (j, k) = d X_j / d xi_k
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k)
        jacobian(j, k) = X[(k + 1) * D + j] - X[j];
    invert(jacobian);
  }

  /// Outward normal of the facet on which the last reference coordinate vanishes, as long as the
  /// facet is large per reference measure, m^(D-1).
  Vector<double, D> facet() const {
    Vector<double, D> normal;
    for (int j = 0; j < D; ++j)
      normal[j] = -determinant * inverse_jacobian(D - 1, j);
    return normal;
  }

  void go_to(int q, const CellTabulation& table, const double* X) {
    if (table.affine) {
      const double* const xi = &table.rule.locations[static_cast<std::size_t>(q * D)];
      for (int j = 0; j < D; ++j)
        position[j] = X[j];
      for (int k = 0; k < D; ++k)
        for (int j = 0; j < D; ++j)
          position[j] += xi[k] * (X[(k + 1) * D + j] - X[j]);
      return;
    }
    const int nodes = table.geometry.nodes;
    const double* const N = &table.geometry.values[static_cast<std::size_t>(q * nodes)];
    const double* const slope = &table.geometry.gradients[static_cast<std::size_t>(q * nodes * D)];
    Tensor<double, D> jacobian;
    position = {};
    for (int a = 0; a < nodes; ++a)
      for (int j = 0; j < D; ++j) {
        position[j] += N[a] * X[a * D + j];
        for (int k = 0; k < D; ++k)
          jacobian(j, k) += slope[a * D + k] * X[a * D + j];
      }
    invert(jacobian);
  }

 private:
  void invert(const Tensor<double, D>& jacobian) {
    determinant = hawser::determinant(jacobian);
    inverse_jacobian = adjugate(jacobian);
    for (int k = 0; k < D; ++k)
      for (int j = 0; j < D; ++j)
        inverse_jacobian(k, j) /= determinant;
  }
};

/// Length, area or volume per that of the reference cell, at point q of the rule, of a cell of any
/// dimension in space: `X` is [node of the map][3], m.
double stretch_at(int q, const Quadrature& rule, const Tabulation& geometry, const double* X);

}  // namespace hawser
