#include "multigrid_factor.hpp"

// All of MueLu is in this file: it compiles slowly.
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>

#include "hawser/base/error.hpp"
#include "sub_matrix.hpp"

namespace hawser {
namespace {

using Local = TpetraMap::local_ordinal_type;
using Global = TpetraMap::global_ordinal_type;
using Node = TpetraMap::node_type;
using Vectors = Teuchos::RCP<TpetraMultiVector>;

/// Metres become kilometres, so that rotations have the size of translations.
constexpr double length_unit = 1e3;

Vectors node_positions(const GroupRows& group, const TpetraMatrix& matrix) {
  const auto dimension = static_cast<std::size_t>(group.dimension);
  const std::size_t nodes = group.positions.size() / dimension;
  const auto x =
      Teuchos::rcp(new TpetraMultiVector(consecutive(*matrix.getRowMap(), nodes), dimension));
  for (std::size_t node = 0; node < nodes; ++node)
    for (std::size_t j = 0; j < dimension; ++j)
      x->replaceLocalValue(static_cast<Local>(node), j,
                           group.positions[node * dimension + j] / length_unit);
  return x;
}

/// A constant of each unknown, and of displacements the rotations.
Vectors near_null_space(const GroupRows& group, const TpetraMatrix& matrix,
                        const TpetraMultiVector& positions) {
  const auto per_node = static_cast<std::size_t>(group.per_node);
  const std::size_t rotations =
      group.displaces ? (per_node * (per_node - 1)) / 2 : 0;  // in the plane one, in space three
  const auto modes = Teuchos::rcp(new TpetraMultiVector(matrix.getRowMap(), per_node + rotations));
  std::vector<double> centre(per_node, 0.0);
  if (rotations > 0) {
    Teuchos::Array<double> mean(per_node);
    positions.meanValue(mean());
    centre.assign(mean.begin(), mean.end());
  }
  const auto x = positions.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t node = 0; node < positions.getLocalLength(); ++node) {
    const auto first = static_cast<Local>(node * per_node);
    for (std::size_t i = 0; i < per_node; ++i)
      modes->replaceLocalValue(first + static_cast<Local>(i), i, 1.0);
    std::size_t mode = per_node;
    for (std::size_t i = 0; rotations > 0 && i < per_node; ++i)
      for (std::size_t j = 0; j < i; ++j, ++mode) {
        modes->replaceLocalValue(first + static_cast<Local>(i), mode, x(node, j) - centre[j]);
        modes->replaceLocalValue(first + static_cast<Local>(j), mode, centre[i] - x(node, i));
      }
  }
  return modes;
}

/// What a prototype found best on the matrices of tows
/// (doc/decisions/0065-a-block-preconditioner.md).
Teuchos::ParameterList parameters(const GroupRows& group, bool parallel) {
  Teuchos::ParameterList list;
  list.set("verbosity", "none");
  list.set("number of equations", group.per_node);
  list.set("multigrid algorithm", "sa");
  list.set("sa: damping factor", 1.33);
  list.set("aggregation: type", "uncoupled");
  list.set("coarse: max size", 1000);
  list.set("coarse: type", "KLU2");
  auto& smoother = list.sublist("smoother: params");
  if (group.displaces) {
    list.set("smoother: type", "RELAXATION");
    smoother.set("relaxation: type", "Symmetric Gauss-Seidel");
    smoother.set("relaxation: sweeps", 2);
  } else {
    list.set("smoother: type", "SCHWARZ");
    smoother.set("schwarz: overlap level", 1);
    smoother.set("schwarz: use reordering", false);  // with it twice the iterations
    smoother.set("inner preconditioner name", "RILUK");
    smoother.sublist("inner preconditioner parameters").set("fact: iluk level-of-fill", 1);
  }
  if (parallel) {  // KLU2 of a matrix on several ranks is silently wrong
    list.set("repartition: enable", true);
    list.set("repartition: partitioner", "zoltan2");
    list.set("repartition: start level", 1);
    list.set("repartition: min rows per proc", 4000);
    list.set("repartition: max imbalance", 1.3);
    list.set("repartition: rebalance P and R", true);
  }
  return list;
}

}  // namespace

struct MultigridFactor::Hierarchy {
  GroupRows group;
  Teuchos::RCP<const TpetraMatrix> matrix;
  Teuchos::RCP<MueLu::TpetraOperator<double, Local, Global, Node>> cycle;

  void make(bool parallel) {
    Teuchos::ParameterList list = parameters(group, parallel);
    auto& data = list.sublist("user data");
    const Vectors positions = node_positions(group, *matrix);
    data.set("Coordinates", positions);
    data.set("Nullspace", near_null_space(group, *matrix, *positions));
    const Teuchos::RCP<TpetraOperator> fine = Teuchos::rcp_const_cast<TpetraMatrix>(matrix);
    cycle = MueLu::CreateTpetraPreconditioner<double, Local, Global, Node>(fine, list);
  }

  /// Whether this rank has a part of the coarsest matrix. MueLu leaves a null operator, which is no
  /// matrix, on ranks from which it took all rows.
  bool holds_coarsest() const {
    using Operator = Teuchos::RCP<Xpetra::Operator<double, Local, Global, Node>>;
    using Matrix = Teuchos::RCP<Xpetra::Matrix<double, Local, Global, Node>>;
    const auto hierarchy = cycle->GetHierarchy();
    const auto level = hierarchy->GetLevel(hierarchy->GetNumLevels() - 1);
    if (level->GetTypeName("A") == Teuchos::TypeNameTraits<Operator>::name()) return false;
    const Matrix coarsest = level->Get<Matrix>("A");
    return !coarsest.is_null() && coarsest->getNodeNumRows() > 0;
  }
};

MultigridFactor::MultigridFactor(const Communicator& communicator, const GroupRows& group)
    : communicator_(communicator), hierarchy_(std::make_unique<Hierarchy>()) {
  hierarchy_->group = group;
}

MultigridFactor::~MultigridFactor() = default;

void MultigridFactor::symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) {
  hierarchy_->matrix = matrix;
}

void MultigridFactor::numeric() {
  communicator_.together([&] {
    try {
      hierarchy_->make(communicator_.size() > 1);
    } catch (const std::exception& error) {
      throw SolveError(std::string("multigrid: ") + error.what());
    }
  });
  if (communicator_.sum(static_cast<long long>(hierarchy_->holds_coarsest() ? 1 : 0)) > 1)
    throw SolveError("multigrid: the coarsest matrix stays on several ranks");
  TpetraVector ones(hierarchy_->matrix->getRangeMap());
  TpetraVector probe(hierarchy_->matrix->getRangeMap());
  ones.putScalar(1.0);
  solve(ones, probe);
  if (!std::isfinite(probe.norm2())) throw SolveError("multigrid: a pivot of a smoother vanishes");
}

void MultigridFactor::solve(const TpetraMultiVector& b, TpetraMultiVector& x) const {
  x.putScalar(0.0);
  hierarchy_->cycle->apply(b, x);
}

}  // namespace hawser
