#pragma once
// One scalar equation per row, all alike: the smallest problem that can go wrong in a chosen way.
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>
#include <functional>

#include "hawser/algebra/nonlinear_problem.hpp"
#include "hawser/base/error.hpp"

namespace hawser::test {

class PointwiseProblem : public NonlinearProblem {
 public:
  /// `function` gives the residual of x in a row; where that is a NaN, x is not admissible.
  PointwiseProblem(std::function<double(double)> function, std::function<double(double)> slope)
      : function_(std::move(function)), slope_(std::move(slope)) {
    const auto comm = Tpetra::getDefaultComm();
    system_.rows = Teuchos::rcp(new TpetraMap(10, 0, comm));
    system_.columns = system_.rows;
    const auto graph = Teuchos::rcp(new Tpetra::CrsGraph<>(system_.rows, system_.rows, 1));
    system_.blocks = {{"upper", "height", "m", {}}};
    for (LocalIndex row = 0; row < size(); ++row) {
      graph->insertLocalIndices(row, 1, &row);
      system_.blocks[0].rows.push_back(row);
    }
    graph->fillComplete();
    system_.matrix = Teuchos::rcp(new TpetraMatrix(graph));
    system_.matrix->fillComplete();
  }

  BlockSystem& system() override { return system_; }

  void residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) override {
    const auto values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    bool admissible = true;
    for (LocalIndex row = 0; row < size(); ++row) {
      const double value = function_(values(row, 0));
      admissible = admissible && (report_nan_as_value || !std::isnan(value));
      f.replaceLocalValue(row, value);
      magnitude.replaceLocalValue(row, least_magnitude + std::abs(value));
    }
    if (system_.communicator.any(!admissible)) throw SolveError("height is not admissible");
  }

  void jacobian(const TpetraVector& x) override {
    const auto values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    system_.matrix->resumeFill();
    for (LocalIndex row = 0; row < size(); ++row) {
      const double value = slope_(values(row, 0));
      system_.matrix->replaceLocalValues(row, 1, &value, &row);
    }
    system_.matrix->fillComplete(system_.rows, system_.rows);
  }

  TpetraVector guess(double value) const {
    TpetraVector x(system_.rows);
    x.putScalar(value);
    return x;
  }

  double least_magnitude = 1.0;
  bool report_nan_as_value = false;  ///< leave it to the driver to notice

 private:
  LocalIndex size() const { return static_cast<LocalIndex>(system_.rows->getNodeNumElements()); }

  BlockSystem system_;
  std::function<double(double)> function_, slope_;
};

}  // namespace hawser::test
