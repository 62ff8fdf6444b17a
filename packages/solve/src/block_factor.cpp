#include "block_factor.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include "hawser/base/error.hpp"
#include "row_scaling.hpp"
#include "with_ghosts.hpp"

namespace hawser {
namespace {

/// The row's unknown from b and the other unknowns on this rank.
double solve_row(const TpetraMatrix::local_matrix_host_type& matrix, LocalIndex row, double b,
                 const TpetraVector& x) {
  const auto values = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  double diagonal = 1, rest = b;
  for (auto k = matrix.graph.row_map(row); k < matrix.graph.row_map(row + 1); ++k) {
    const auto column = matrix.graph.entries(k);  // the rows, then the ghosts
    if (column == row)
      diagonal = matrix.values(k);
    else if (column < matrix.numRows())
      rest -= matrix.values(k) * values(column, 0);
  }
  return rest / diagonal;
}

}  // namespace

BlockFactor::BlockFactor(const BlockSystem& system, const RowScaling& scaling,
                         const LinearOptions& options)
    : system_(system), scaling_(scaling), wanted_(options), options_(options) {}

BlockFactor::~BlockFactor() = default;

void BlockFactor::symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) {
  matrix_ = matrix;
  groups_.clear();
  all_ = Teuchos::rcp(new TpetraVector(matrix->getColMap()));
}

void BlockFactor::build() {
  const RowLayout& layout = system_.layout;
  prescribed_ = layout.prescribed;
  groups_.clear();
  known_.clear();
  following_.clear();
  const bool as_one = as_one_ || layout.groups.empty() || system_.communicator.any(!layout.ordered);
  std::string text = "linear solver: ";
  const auto add = [&](int group) {
    groups_.push_back(std::make_unique<GroupSolver>(system_, *matrix_, group, options_));
    text += (groups_.size() > 1 ? "; " : "") + groups_.back()->description();
  };
  if (as_one) {
    add(GroupRows::everything);
  } else {
    for (std::size_t row = 0; row < layout.group.size(); ++row)
      if (!layout.prescribed.empty() && layout.prescribed[row] != 0)
        known_.push_back(static_cast<LocalIndex>(row));
      else if (layout.group[row] == RowLayout::follows)
        following_.push_back(static_cast<LocalIndex>(row));
    for (std::size_t group = 0; group < layout.groups.size(); ++group)
      add(static_cast<int>(group));
  }
  if (text != told_) notes_.push_back(text);
  told_ = text;
}

void BlockFactor::take() {
  const auto& scales = scaling_.factors();
  unscale_.resize(scales.size());
  for (std::size_t row = 0; row < scales.size(); ++row)
    unscale_[row] = 1 / scales[row];  // powers of two
  for (const auto& group : groups_)
    group->take(*matrix_, unscale_);
}

void BlockFactor::numeric() {
  if (groups_.empty() || system_.communicator.any(prescribed_ != system_.layout.prescribed))
    build();
  take();
  try {
    for (const auto& group : groups_)
      group->numeric();
  } catch (const SolveError& error) {
    if (!fall_back()) throw;
    notes_.push_back(error.what());
    numeric();
  }
}

void BlockFactor::adapt() {
  take();
  for (const auto& group : groups_)
    group->adapt();
}

bool BlockFactor::fall_back() {
  using Method = LinearOptions::BlockMethod;
  if (as_one_ || (groups_.size() == 1 && system_.layout.groups.size() != 1)) return false;
  if (options_.block_method == Method::direct)
    as_one_ = true;
  else
    options_.block_method = Method::direct;
  groups_.clear();
  return true;
}

void BlockFactor::start_over() {
  if (as_one_ || options_.block_method != wanted_.block_method) groups_.clear();
  options_ = wanted_;
  as_one_ = false;
}

std::vector<std::string> BlockFactor::take_notes() { return std::exchange(notes_, {}); }

void BlockFactor::solve_known(const TpetraVector& b, TpetraVector& x) const {
  const auto matrix = matrix_->getLocalMatrixHost();
  const auto from = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const LocalIndex row : known_)
    x.replaceLocalValue(row, solve_row(matrix, row, from(row, 0), x));
}

void BlockFactor::follow(const TpetraVector& b, TpetraVector& x) const {
  const auto matrix = matrix_->getLocalMatrixHost();
  const auto from = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (const LocalIndex row : following_)
    x.replaceLocalValue(row, solve_row(matrix, row, from(row, 0), x));
}

void BlockFactor::solve(const TpetraMultiVector& b, TpetraMultiVector& x) const {
  x.putScalar(0.0);
  for (std::size_t column = 0; column < b.getNumVectors(); ++column) {
    const auto from = b.getVector(column);
    const auto to = x.getVectorNonConst(column);
    solve_known(*from, *to);
    follow(*from, *to);
    for (const auto& group : groups_) {
      with_ghosts(*matrix_, *to, *all_);
      group->solve(*matrix_, unscale_, *from, *all_, *to);
      follow(*from, *to);
    }
  }
}

}  // namespace hawser
