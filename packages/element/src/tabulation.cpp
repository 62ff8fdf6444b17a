#include "hawser/element/tabulation.hpp"

#include <Intrepid2_DefaultCubatureFactory.hpp>
#include <Intrepid2_HGRAD_HEX_C1_FEM.hpp>
#include <Intrepid2_HGRAD_HEX_C2_FEM.hpp>
#include <Intrepid2_HGRAD_LINE_C1_FEM.hpp>
#include <Intrepid2_HGRAD_LINE_Cn_FEM.hpp>
#include <Intrepid2_HGRAD_QUAD_C1_FEM.hpp>
#include <Intrepid2_HGRAD_QUAD_C2_FEM.hpp>
#include <Intrepid2_HGRAD_TET_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TET_C2_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C1_FEM.hpp>
#include <Intrepid2_HGRAD_TRI_C2_FEM.hpp>

#include <stdexcept>
#include <string>

namespace hawser {
namespace {

using Device = Kokkos::Device<Kokkos::Serial, Kokkos::HostSpace>;
using Functions = Intrepid2::Basis<Device, double, double>;
using Array = Kokkos::DynRankView<double, Device>;

template <class D, class V, class P>
struct QuadraticLine : Intrepid2::Basis_HGRAD_LINE_Cn_FEM<D, V, P> {
  QuadraticLine() : Intrepid2::Basis_HGRAD_LINE_Cn_FEM<D, V, P>(2) {}
};

template <template <class, class, class> class Linear,
          template <class, class, class> class Quadratic>
Teuchos::RCP<Functions> choose(Basis basis) {
  if (basis == Basis::p1) return Teuchos::rcp(new Linear<Device, double, double>());
  return Teuchos::rcp(new Quadratic<Device, double, double>());
}

Teuchos::RCP<Functions> make_functions(CellShape shape, Basis basis) {
  using namespace Intrepid2;
  switch (shape) {
    case CellShape::line: return choose<Basis_HGRAD_LINE_C1_FEM, QuadraticLine>(basis);
    case CellShape::triangle: return choose<Basis_HGRAD_TRI_C1_FEM, Basis_HGRAD_TRI_C2_FEM>(basis);
    case CellShape::quadrilateral:
      return choose<Basis_HGRAD_QUAD_C1_FEM, Basis_HGRAD_QUAD_C2_FEM>(basis);
    case CellShape::tetrahedron:
      return choose<Basis_HGRAD_TET_C1_FEM, Basis_HGRAD_TET_C2_FEM>(basis);
    case CellShape::hexahedron:
      return choose<Basis_HGRAD_HEX_C1_FEM, Basis_HGRAD_HEX_C2_FEM>(basis);
    default: throw std::logic_error("no shape functions on " + std::string(traits(shape).plural));
  }
}

/// Lines, quadrilaterals and hexahedra of Intrepid2 are [-1, 1]^n, ours [0, 1]^n.
double stretch(CellShape shape) {
  return shape == CellShape::line || !traits(shape).simplex ? 2 : 1;
}

/// Intrepid2's number of each of our nodes: by dimension of the part of the cell that it sits on.
std::vector<int> node_order(const Functions& functions) {
  std::vector<int> order;
  const auto topology = functions.getBaseCellTopology();
  const auto ordinals = functions.getAllDofOrdinal();
  for (unsigned d = 0; d <= topology.getDimension(); ++d)
    for (unsigned part = 0; part < topology.getSubcellCount(d); ++part)
      if (d < ordinals.extent(0) && part < ordinals.extent(1) && ordinals(d, part, 0) >= 0)
        order.push_back(ordinals(d, part, 0));
  return order;
}

}  // namespace

Quadrature quadrature(CellShape shape, int degree) {
  const auto rule = Intrepid2::DefaultCubatureFactory().create<Device, double, double>(
      make_functions(shape, Basis::p1)->getBaseCellTopology(), degree);
  Quadrature result;
  result.shape = shape;
  result.points = rule->getNumPoints();
  const auto dimension = static_cast<std::size_t>(traits(shape).dimension);
  Array points("points", static_cast<std::size_t>(result.points), dimension);
  Array weights("weights", static_cast<std::size_t>(result.points));
  rule->getCubature(points, weights);
  const double length = stretch(shape);
  double cell = 1;
  for (std::size_t k = 0; k < dimension; ++k)
    cell *= length;
  for (std::size_t q = 0; q < points.extent(0); ++q) {
    result.weights.push_back(weights(q) / cell);
    for (std::size_t k = 0; k < dimension; ++k)
      result.locations.push_back(length == 1 ? points(q, k) : 0.5 * (points(q, k) + 1));
  }
  return result;
}

Quadrature facet_quadrature(CellShape shape, int degree) {
  const ShapeTraits& cell = traits(shape);
  const CellShape facet = cell.dimension == 2 ? CellShape::line
                          : cell.simplex      ? CellShape::triangle
                                              : CellShape::quadrilateral;
  const Quadrature on_facet = quadrature(facet, degree);
  Quadrature result;
  result.shape = shape;
  result.points = on_facet.points;
  result.weights = on_facet.weights;
  auto from = on_facet.locations.begin();
  for (int q = 0; q < result.points; ++q) {
    for (int k = 0; k + 1 < cell.dimension; ++k)
      result.locations.push_back(*from++);
    result.locations.push_back(0);
  }
  return result;
}

Tabulation tabulate(Basis basis, const Quadrature& rule) {
  const auto functions = make_functions(rule.shape, basis);
  const auto dimension = static_cast<std::size_t>(traits(rule.shape).dimension);
  const auto point_count = static_cast<std::size_t>(rule.points);
  const auto node_count = static_cast<std::size_t>(functions->getCardinality());
  const double length = stretch(rule.shape);
  Array points("points", point_count, dimension);
  for (std::size_t q = 0; q < point_count; ++q)
    for (std::size_t k = 0; k < dimension; ++k)
      points(q, k) = length * rule.locations[q * dimension + k] - (length - 1);
  Array values("values", node_count, point_count);
  Array gradients("gradients", node_count, point_count, dimension);
  functions->getValues(values, points, Intrepid2::OPERATOR_VALUE);
  functions->getValues(gradients, points, Intrepid2::OPERATOR_GRAD);

  Tabulation result;
  result.nodes = static_cast<int>(node_count);
  const std::vector<int> order = node_order(*functions);
  for (std::size_t q = 0; q < point_count; ++q)
    for (const int a : order) {
      result.values.push_back(values(a, q));
      for (std::size_t k = 0; k < dimension; ++k)
        result.gradients.push_back(length * gradients(a, q, k));
    }
  const auto first = result.gradients.begin();
  const auto width = static_cast<std::ptrdiff_t>(node_count * dimension);
  result.linear = true;
  for (auto point = first; point != result.gradients.end(); point += width)
    result.linear = result.linear && std::equal(first, first + width, point);
  return result;
}

CellTabulation tabulate_cell(const std::vector<Basis>& fields, const Quadrature& rule) {
  CellTabulation result{rule, tabulate(Basis::p1, rule), traits(rule.shape).simplex, {}};
  for (const Basis basis : fields)
    result.fields.push_back(tabulate(basis, rule));
  return result;
}

}  // namespace hawser
