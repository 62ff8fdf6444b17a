#include "group_solver.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include "multigrid_factor.hpp"
#include "mumps_factor.hpp"

namespace hawser {

GroupSolver::GroupSolver(const BlockSystem& system, const TpetraMatrix& scaled, int group,
                         const LinearOptions& options)
    : system_(system), options_(options) {
  const GroupRows rows = group_rows(system, scaled, group, options.block_method);
  as_they_are_ = rows.as_they_are;
  const auto map = consecutive(*system.rows, rows.rows.size());
  part_ = std::make_unique<SubMatrix>(scaled, rows.rows, map,
                                      group_columns(system, scaled, rows, *map));
  seeds_ = leaders_nodes(system, rows);
  right_ = Teuchos::rcp(new TpetraVector(map));
  left_ = Teuchos::rcp(new TpetraVector(map));
  exact_ = rows.per_node == 0;
  description_ = rows.name + ": " + (exact_ ? "MUMPS" : "multigrid");
  if (!rows.objection.empty()) description_ += ", not multigrid, because " + rows.objection;
  if (map->getGlobalNumElements() == 0) return;
  if (exact_)
    factor_ = std::make_unique<MumpsFactor>(system.communicator, options.repeatable);
  else
    factor_ = std::make_unique<MultigridFactor>(system.communicator, rows);
}

void GroupSolver::take(const TpetraMatrix& scaled, const std::vector<double>& unscale) {
  std::vector<double> weights;
  if (!as_they_are_) {
    weights.assign(scaled.getNodeNumCols(), 1.0);
    for (const Follower& follower : system_.layout.followers)
      weights[static_cast<std::size_t>(follower.row)] = system_.layout.factor;
  }
  part_->take(scaled, unscale, weights);
}

void GroupSolver::numeric() {
  if (!factor_) return;
  if (!analysed_) factor_->symbolic(part_->matrix());
  analysed_ = true;
  factor_->numeric();
  patched_ = false;
  if (!exact_) adapt();
}

void GroupSolver::adapt() {
  if (!factor_) return;
  if (!patch_)
    patch_ =
        std::make_unique<Patch>(system_.communicator, part_->matrix(), seeds_, options_.repeatable);
  if (!patch_->exists()) return;
  patch_->numeric();
  patched_ = true;
}

void GroupSolver::solve(const TpetraMatrix& scaled, const std::vector<double>& unscale,
                        const TpetraVector& b, const TpetraVector& all, TpetraVector& x) const {
  if (!factor_) return;
  const std::vector<LocalIndex>& rows = part_->rows();
  {
    const auto local = scaled.getLocalMatrixHost();
    const auto from = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto known = all.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto right = right_->getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      right(i, 0) = 0;
      if (rows[i] == SubMatrix::identity) continue;
      double rest = from(rows[i], 0);
      for (auto k = local.graph.row_map(rows[i]); k < local.graph.row_map(rows[i] + 1); ++k)
        rest -= local.values(k) * known(local.graph.entries(k), 0);
      right(i, 0) = rest * unscale[static_cast<std::size_t>(rows[i])];
    }
  }
  factor_->solve(*right_, *left_);
  if (patched_) patch_->correct(*right_, *left_);
  const auto left = left_->getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto to = x.getLocalViewHost(Tpetra::Access::ReadWrite);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i] != SubMatrix::identity) to(rows[i], 0) = left(i, 0);
}

}  // namespace hawser
