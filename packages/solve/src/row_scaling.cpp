#include "row_scaling.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"

namespace hawser {

void RowScaling::compute(const TpetraMatrix& matrix, const Communicator& communicator) {
  const auto local = matrix.getLocalMatrixHost();
  factors_.assign(static_cast<std::size_t>(local.numRows()), 1.0);
  communicator.together([&] {
    for (LocalIndex row = 0; row < local.numRows(); ++row) {
      double sum = 0;  // a sum, unlike a maximum, does not lose a NaN
      double largest = 0;
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        sum += std::abs(local.values(k));
        largest = std::max(largest, std::abs(local.values(k)));
      }
      if (!std::isfinite(sum) || largest == 0) {
        const auto number = std::to_string(matrix.getRowMap()->getGlobalElement(row));
        throw SolveError("linear solver: row " + number + " of the matrix " +
                         (largest == 0 && sum == 0 ? "is zero, so the matrix is singular"
                                                   : "holds a value that is not finite"));
      }
      factors_[static_cast<std::size_t>(row)] = std::ldexp(1.0, -std::ilogb(largest));
    }
  });
}

void RowScaling::apply(const TpetraMatrix& from, TpetraMatrix& to) const {
  const auto source = from.getLocalMatrixHost();
  const auto target = to.getLocalMatrixHost();
  for (LocalIndex row = 0; row < source.numRows(); ++row) {
    const double factor = factors_[static_cast<std::size_t>(row)];
    for (auto k = source.graph.row_map(row); k < source.graph.row_map(row + 1); ++k)
      target.values(k) = factor * source.values(k);
  }
}

void RowScaling::apply(const TpetraVector& from, TpetraVector& to) const {
  const auto source = from.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto target = to.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t row = 0; row < factors_.size(); ++row)
    target(row, 0) = factors_[row] * source(row, 0);
}

}  // namespace hawser
