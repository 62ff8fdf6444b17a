#pragma once
// A formula of place, time and fields at points all over a region of the moved mesh: a body, a
// line, or the boundary of the body, where derivatives are those in the cell beside it and
// normal_x, normal_y point out of it.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "hawser/fields/formula_fields.hpp"

namespace hawser {

class RegionSampling {
 public:
  /// What does not fit goes to `diagnostics`; the same on all ranks. Collective.
  /// `points`: in a cell of a shape, for a formula of a degree (FormulaFields::quadrature_degree).
  using Points = std::function<Quadrature(CellShape shape, int degree)>;
  RegionSampling(const DofMap& dofs, const Region& region, const FieldExpression& formula,
                 int moving, const Points& points, Diagnostics& diagnostics);

  const FormulaFields& formula() const { return formula_; }

  struct Sample {
    GlobalIndex cell;  ///< of the region
    int point;         ///< in the cell
    double weight;     ///< of a quadrature point with its share of the region, m or m^2
    const SpaceTime& place;
    double value;
  };
  /// visit(sample) at every point of the cells that this rank counts. SolveError where the formula
  /// has no value, on this rank alone.
  template <class Visit>
  void visit(const State& state, Visit&& visit);

 private:
  struct Side {
    LocalIndex cell;  // of the body, beside the region's; -1: this rank does not count that one
    std::size_t edge;
  };
  static std::vector<Side> sides_of(const Mesh& mesh, const Region& region);
  bool check_fields(Diagnostics& diagnostics);
  bool lives_beside(int field) const;
  FieldSampler& at_side(const Side& side) { return samplers_[side.edge]; }
  /// The outward normal there; its length is that of the edge per that of the reference edge.
  Vector<double, 3> normal(const Side& side) const;

  const DofMap& dofs_;
  const Region& region_;
  std::vector<Side> sides_;  // per cell of a region on the boundary of the body; else none
  FormulaFields formula_;
  std::vector<FieldSampler> samplers_;  // the region's; or, of the body's cells, one per edge
};

template <class Visit>
void RegionSampling::visit(const State& state, Visit&& visit) {
  const int rank = dofs_.mesh().communicator.rank();
  for (LocalIndex cell = 0; cell < region_.size(); ++cell) {
    const auto c = static_cast<std::size_t>(cell);
    if (region_.cell_owners[c] != rank) continue;
    FieldSampler& at = sides_.empty() ? samplers_.front() : at_side(sides_[c]);
    at.enter(sides_.empty() ? cell : sides_[c].cell, state);
    for (int q = 0; q < at.points().points; ++q) {
      at.go_to(q);
      const double share = at.points().weights[static_cast<std::size_t>(q)];
      if (sides_.empty()) {
        visit(Sample{region_.cell_ids[c], q, share * at.stretch(), at.place(), formula_.value(at)});
        continue;
      }
      Vector<double, 3> out = normal(sides_[c]);
      const double length = std::sqrt(dot(out, out));
      for (int j = 0; j < 3; ++j)
        out[j] /= length;
      visit(Sample{region_.cell_ids[c], q, share * length, at.place(), formula_.value(at, out)});
    }
  }
}

/// Points on a lattice that cuts every edge into as many parts: 1 gives the vertices.
Quadrature lattice(CellShape shape, int parts);

}  // namespace hawser
