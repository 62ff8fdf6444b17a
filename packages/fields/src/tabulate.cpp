#include "hawser/fields/tabulate.hpp"

#include <Intrepid2_DefaultCubatureFactory.hpp>
#include <Intrepid2_HGRAD_LINE_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C2_FEM.hpp>

#include <memory>
#include <stdexcept>

namespace hawser {
namespace {

using Device = Kokkos::Device<Kokkos::Serial, Kokkos::HostSpace>;
using BasisPointer = Intrepid2::BasisPtr<Device, double, double>;

BasisPointer make_basis(CellShape shape, Basis basis) {
  if (shape == CellShape::triangle) {
    if (basis == Basis::p1)
      return Teuchos::rcp(new Intrepid2::Basis_HGRAD_TRI_C1_FEM<Device, double, double>());
    return Teuchos::rcp(new Intrepid2::Basis_HGRAD_TRI_C2_FEM<Device, double, double>());
  }
  if (shape == CellShape::line && basis == Basis::p1)
    return Teuchos::rcp(new Intrepid2::Basis_HGRAD_LINE_C1_FEM<Device, double, double>());
  throw std::logic_error("tabulate: no shape functions for this cell shape");
}

}  // namespace

Tabulation tabulate(CellShape shape, Basis basis, int degree) {
  const BasisPointer functions = make_basis(shape, basis);
  auto rule = Intrepid2::DefaultCubatureFactory().create<Device, double, double>(
      functions->getBaseCellTopology(), degree);

  Tabulation result;
  result.points = rule->getNumPoints();
  result.dimension = static_cast<int>(functions->getBaseCellTopology().getDimension());
  result.nodes = functions->getCardinality();
  const auto point_count = static_cast<std::size_t>(result.points);
  const auto node_count = static_cast<std::size_t>(result.nodes);
  const auto dimension = static_cast<std::size_t>(result.dimension);

  using Array = Kokkos::DynRankView<double, Device>;
  Array points("points", point_count, dimension);
  Array weights("weights", point_count);
  Array values("values", node_count, point_count);
  Array gradients("gradients", node_count, point_count, dimension);
  rule->getCubature(points, weights);
  functions->getValues(values, points, Intrepid2::OPERATOR_VALUE);
  functions->getValues(gradients, points, Intrepid2::OPERATOR_GRAD);

  // Intrepid2's line is [-1, 1].
  const bool is_line = shape == CellShape::line;
  for (std::size_t q = 0; q < point_count; ++q) {
    result.weights.push_back(is_line ? 0.5 * weights(q) : weights(q));
    for (std::size_t k = 0; k < dimension; ++k)
      result.locations.push_back(is_line ? 0.5 * (points(q, k) + 1) : points(q, k));
    for (std::size_t a = 0; a < node_count; ++a) {
      result.values.push_back(values(a, q));
      for (std::size_t k = 0; k < dimension; ++k)
        result.gradients.push_back(is_line ? 2 * gradients(a, q, k) : gradients(a, q, k));
    }
  }
  return result;
}

}  // namespace hawser
