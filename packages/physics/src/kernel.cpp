#include <algorithm>

#include "hawser/base/error.hpp"
#include "hawser/physics/element_kernel.hpp"
#include "hawser/physics/point_kernel.hpp"

namespace hawser {

int Kernel::rate_partner(std::size_t field) const {
  return hawser::rate_partner(fields_.data(), fields_.size(), field);
}

std::vector<double> Kernel::sample_amplitudes() const {
  return std::vector<double>(fields_.size(), 0.1);
}

void detail::check_size(const Kernel& kernel, const CellTabulation& table) {
  int unknowns = 0, most = 0;
  for (std::size_t f = 0; f < table.fields.size(); ++f) {
    most = std::max(most, table.fields[f].nodes);
    unknowns += table.fields[f].nodes * kernel.fields()[f].components;
  }
  if (unknowns > max_unknowns || most > max_nodes)
    throw PluginError("a kernel on '" + kernel.domain().text() + "' has " +
                      std::to_string(unknowns) + " unknowns and up to " + std::to_string(most) +
                      " nodes per cell; there is room for " + std::to_string(max_unknowns) +
                      " and " + std::to_string(max_nodes));
}

void detail::check_domain(const Kernel& kernel, bool on_facets) {
  if (on_facets == (kernel.domain().kind == Domain::Kind::facets)) return;
  throw PluginError("a kernel on '" + kernel.domain().text() + "' " +
                    (on_facets
                         ? "is one on_facets and needs a Domain::facets(...)"
                         : "is written for cells; one for their facets says on_facets = true"));
}

CellTabulation detail::at_vertices(const Kernel& kernel, CellShape shape) {
  const ShapeTraits& of = traits(shape);
  if (of.dimension != kernel.dimension())
    throw PluginError("a kernel on '" + kernel.domain().text() +
                      "' uses a property that is supplied at points of the body, and its cells "
                      "do not fill it");
  Quadrature vertices;
  vertices.shape = shape;
  vertices.points = of.vertices;
  vertices.weights.assign(static_cast<std::size_t>(of.vertices), 0.0);
  for (int v = 0; v < of.vertices; ++v)
    for (int j = 0; j < of.dimension; ++j)
      vertices.locations.push_back(of.vertex[v][j]);
  const Basis linear = Basis::p1;
  return tabulate_cell(std::vector<Basis>(kernel.fields().size(), linear), vertices);
}

}  // namespace hawser
