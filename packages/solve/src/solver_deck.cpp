#include "hawser/solve/solver_deck.hpp"

namespace hawser {
namespace {

Spec<LinearOptions> linear_spec() {
  using P = LinearOptions;
  return Spec<P>("linear", "Solver of the linear equations in each Newton iteration.")
      .choice(
          "method", &P::method,
          {{"gmres", P::Method::gmres}, {"mumps", P::Method::mumps}, {"blocks", P::Method::blocks}},
          "GMRES preconditioned by overlapping Schwarz with an incomplete factor, by MUMPS' "
          "complete one, or block by block.")
      .choice("block-method", &P::block_method,
              {{"auto", P::BlockMethod::automatic},
               {"direct", P::BlockMethod::direct},
               {"multigrid", P::BlockMethod::multigrid}},
              "Of each block of method=\"blocks\": MUMPS' factor, or multigrid (smoothed "
              "aggregation); by its size.")
      .attribute("tolerance", &P::tolerance, "1", between(1e-14, 0.5),
                 "Of the row-scaled residual, relative to the right-hand side.")
      .attribute("restart", &P::restart, at_least(1), "GMRES vectors kept before a restart.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "GMRES iterations before it counts as failed.")
      .attribute("fill-level", &P::fill_level, between(0, 10),
                 "Fill level of the incomplete factor.")
      .attribute("overlap", &P::overlap, between(0, 10),
                 "Schwarz overlap between ranks, in layers.")
      .attribute("keep-factor", &P::keep_factor,
                 "Keep a factor for later matrices until it costs too many iterations.")
      .attribute("refresh-ratio", &P::refresh_ratio, "1", at_least(1),
                 "A kept factor is renewed beyond this multiple of its first iteration count ...")
      .attribute("refresh-slack", &P::refresh_slack, at_least(0), "... plus this many.")
      .attribute("repeatable", &P::repeatable,
                 "MUMPS on one rank, the same to the last bit each time; else on all ranks.");
}

Spec<NonlinearOptions> newton_spec() {
  using P = NonlinearOptions;
  return Spec<P>("newton", "Newton's method.")
      .source("doc/numerics.md, doc/decisions/0003-convergence-norm.md")
      .attribute("tolerance", &P::tolerance, "1", between(1e-15, 1e-1),
                 "Largest residual of a block relative to the contributions that cancel in it.")
      .attribute("update-tolerance", &P::update_tolerance, "1", between(0, 1),
                 "Largest estimated error of a block's unknowns relative to their size: of places "
                 "the cells', of pressures without their mean; 0: not tested.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "Iterations before a step is rejected.")
      .attribute("line-search", &P::line_search,
                 "Halve an update that is not admissible or makes a block explode.")
      .attribute("divergence", &P::divergence, "1", greater_than(1),
                 "Growth of the residual against the first one that ends the solve. Without line "
                 "search a stiff, slender cable passes through large ones.")
      .attribute(
          "pseudo-step", &P::pseudo_step, "1", at_least(0),
          "First step of pseudo-transient continuation, for a steady state that Newton's method "
          "does not reach: smaller is safer and slower; 0: none.")
      .attribute(
          "lagged", &P::lagged,
          absent("in time steps of 1000 unknowns or more to a tolerance not below 1e-8"),
          "Iterate with the Jacobian of an earlier step, Anderson-accelerated, until renewing "
          "it pays; Newton's method where that fails.")
      .attribute("forcing", &P::forcing,
                 "Looser linear solves far from the solution (Eisenstat-Walker).")
      .attribute("forcing-max", &P::forcing_max, "1", between(1e-12, 0.9),
                 "Loosest linear tolerance with forcing.");
}

}  // namespace

Spec<SolverDeck> SolverDeck::spec() {
  return Spec<SolverDeck>("solver", "How the equations are solved.")
      .child(&SolverDeck::linear, linear_spec())
      .child(&SolverDeck::newton, newton_spec());
}

}  // namespace hawser
