#include "gmres.hpp"

#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace hawser {
namespace {

/// Lets Belos see a Factor.
class FactorOperator : public TpetraOperator {
 public:
  FactorOperator(const Factor& factor, Teuchos::RCP<const TpetraMap> map)
      : factor_(factor), map_(std::move(map)) {}

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return map_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return map_; }
  void apply(const TpetraMultiVector& b, TpetraMultiVector& x, Teuchos::ETransp, double,
             double) const override {
    factor_.solve(b, x);
  }

 private:
  const Factor& factor_;
  Teuchos::RCP<const TpetraMap> map_;
};

Teuchos::RCP<Teuchos::ParameterList> belos_parameters(const LinearOptions& options,
                                                      double tolerance) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList);
  list->set("Num Blocks", options.restart);
  list->set("Maximum Iterations", options.max_iterations);
  list->set("Maximum Restarts", options.max_iterations / options.restart + 1);
  list->set("Convergence Tolerance", tolerance);
  list->set("Implicit Residual Scaling", "Norm of RHS");
  list->set("Explicit Residual Scaling", "Norm of RHS");
  list->set("Verbosity", static_cast<int>(Belos::Errors));
  list->set("Output Stream", Teuchos::rcp<std::ostream>(new Teuchos::oblackholestream));
  return list;
}

}  // namespace

GmresOutcome gmres(const Teuchos::RCP<const TpetraMatrix>& matrix, const Factor& factor,
                   const LinearOptions& options, double tolerance, const TpetraVector& b,
                   TpetraVector& x) {
  x.putScalar(0.0);
  using Problem = Belos::LinearProblem<double, TpetraMultiVector, TpetraOperator>;
  const auto problem = Teuchos::rcp(new Problem(matrix, Teuchos::rcpFromRef<TpetraMultiVector>(x),
                                                Teuchos::rcpFromRef<const TpetraMultiVector>(b)));
  problem->setRightPrec(Teuchos::rcp(new FactorOperator(factor, matrix->getRangeMap())));
  problem->setProblem();
  const auto solver = Belos::SolverFactory<double, TpetraMultiVector, TpetraOperator>().create(
      "Block GMRES", belos_parameters(options, tolerance));
  solver->setProblem(problem);
  GmresOutcome outcome;
  try {  // Belos throws when an orthogonalisation breaks down, on all ranks, and for NaN
    outcome.converged = solver->solve() == Belos::Converged;
    outcome.iterations = solver->getNumIters();
  } catch (const std::exception&) {
    outcome.iterations = options.max_iterations;
  }
  return outcome;
}

}  // namespace hawser
