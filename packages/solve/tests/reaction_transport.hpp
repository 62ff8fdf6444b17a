#pragma once
// A manufactured problem with two named blocks whose units lie 1e6 apart, by finite differences:
//
//   heat          1e3  (-lap u - lambda exp(u) + v) = 1e3  s     (Bratu's equation)
//   concentration 1e-3 (-lap v + (c + u) dv/dx) = 1e-3 s
//
// on the unit square, u = v = 0 beyond the edge, s such that the solution is known at every node.
#include "hawser/algebra/nonlinear_problem.hpp"

namespace hawser::test {

class ReactionTransport : public NonlinearProblem {
 public:
  explicit ReactionTransport(int nodes_per_side, double lambda = 2.0);

  BlockSystem& system() override { return system_; }
  void residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) override;
  void jacobian(const TpetraVector& x) override;

  TpetraVector exact() const;
  double speed = 20;  ///< c; the solution stays the same

 private:
  struct Stencil {
    LocalIndex columns[2]
                      [5];  ///< local columns of u and v: here, west, east, south, north; -1: edge
  };
  struct Terms {
    double values[2][8];  ///< contributions that sum to the residual of u and v
  };
  void make_system();
  void make_stencils();
  Terms terms(std::size_t node, const TpetraVector& ghosted) const;
  TpetraVector with_ghosts(const TpetraVector& x) const;

  int side_;
  double lambda_;
  BlockSystem system_;
  std::vector<Stencil> stencils_;  ///< per owned node; its rows are 2 i and 2 i + 1
};

}  // namespace hawser::test
