#include "mumps_factor.hpp"

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>
#include <dmumps_c.h>

#include <string>

#include "hawser/base/error.hpp"

namespace hawser {

// MUMPS documents its arrays from 1, as Fortran counts.
struct MumpsFactor::Mumps : DMUMPS_STRUC_C {
  int& control(int i) { return icntl[i - 1]; }
};

namespace {
enum Job { begin = -1, end = -2, analyse = 1, factorise = 2, substitute = 3 };
constexpr int working_space_too_small = -9;
constexpr int working_space_too_small_for_solve = -11;
}  // namespace

MumpsFactor::Layout::Layout(const Communicator& communicator, int mine)
    : counts(static_cast<std::size_t>(communicator.size())), offsets(1, 0) {
  MPI_Allgather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator.mpi());
  for (const int count : counts)
    offsets.push_back(offsets.back() + count);
}

MumpsFactor::MumpsFactor(const Communicator& communicator, bool repeatable)
    : communicator_(communicator),
      on_root_(repeatable && communicator.size() > 1),
      mumps_(std::make_unique<Mumps>()) {
  const MPI_Comm comm = on_root_ ? MPI_COMM_SELF : communicator.mpi();
  mumps_->comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm));
  mumps_->par = 1;  // rank 0 works too
  mumps_->sym = 0;
  run(begin);
  for (const int stream : {1, 2, 3})
    mumps_->control(stream) = -1;  // print nothing
  mumps_->control(4) = 0;
  mumps_->control(18) = 3;   // entries stay on the ranks that own their rows
  mumps_->control(14) = 40;  // percent of working space beyond the estimate
}

MumpsFactor::~MumpsFactor() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized || (on_root_ && !communicator_.is_root())) return;
  mumps_->job = end;
  dmumps_c(mumps_.get());
}

bool MumpsFactor::out_of_space() const {
  return result_[0] == working_space_too_small || result_[0] == working_space_too_small_for_solve;
}

void MumpsFactor::run(int job) const {
  if (!on_root_ || communicator_.is_root()) {
    mumps_->job = job;
    dmumps_c(mumps_.get());
    result_[0] = mumps_->infog[0];
    result_[1] = mumps_->infog[1];
  }
  if (on_root_) MPI_Bcast(result_, 2, MPI_INT, 0, communicator_.mpi());
  const int code = result_[0];
  if (code >= 0 || out_of_space()) return;
  if (code == -6 || code == -10) throw SolveError("linear solver: the matrix is singular (MUMPS)");
  throw SolveError("linear solver: MUMPS error " + std::to_string(code) + ", detail " +
                   std::to_string(result_[1]));
}

void MumpsFactor::number_entries() {
  const auto rows = matrix_->getRowMap();
  const auto columns = matrix_->getColMap();
  const auto owned = static_cast<int>(rows->getNodeNumElements());
  rows_ = Layout(communicator_, owned);
  const int first = rows_.offsets[static_cast<std::size_t>(communicator_.rank())];

  // Numbers travel to ghost columns as doubles, exact up to 2^53.
  TpetraVector row_number(rows);
  TpetraVector column_number(columns);
  for (int row = 0; row < owned; ++row)
    row_number.replaceLocalValue(row, first + row + 1.0);
  column_number.doImport(row_number, Tpetra::Import<>(rows, columns), Tpetra::INSERT);

  const auto number = column_number.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto local = matrix_->getLocalMatrixHost();
  row_numbers_.clear();
  column_numbers_.clear();
  for (int row = 0; row < owned; ++row) {
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      row_numbers_.push_back(first + row + 1);
      column_numbers_.push_back(static_cast<int>(number(local.graph.entries(k), 0)));
    }
  }
}

void MumpsFactor::gather_entries() {
  entries_ = Layout(communicator_, static_cast<int>(row_numbers_.size()));
  for (auto* numbers : {&row_numbers_, &column_numbers_}) {
    std::vector<int> all(static_cast<std::size_t>(entries_.offsets.back()));
    MPI_Gatherv(numbers->data(), static_cast<int>(numbers->size()), MPI_INT, all.data(),
                entries_.counts.data(), entries_.offsets.data(), MPI_INT, 0, communicator_.mpi());
    *numbers = std::move(all);
  }
  gathered_.resize(row_numbers_.size());
}

void MumpsFactor::symbolic(const Teuchos::RCP<const TpetraMatrix>& matrix) {
  matrix_ = matrix;
  number_entries();
  if (on_root_) gather_entries();
  if (communicator_.is_root()) whole_.resize(static_cast<std::size_t>(rows_.offsets.back()));
  mumps_->n = rows_.offsets.back();
  mumps_->nnz_loc = static_cast<MUMPS_INT8>(row_numbers_.size());
  mumps_->irn_loc = row_numbers_.data();
  mumps_->jcn_loc = column_numbers_.data();
  run(analyse);
}

void MumpsFactor::numeric() {
  const auto values = matrix_->getLocalMatrixHost().values;
  mumps_->a_loc = values.data();
  if (on_root_) {
    MPI_Gatherv(values.data(), static_cast<int>(values.extent(0)), MPI_DOUBLE, gathered_.data(),
                entries_.counts.data(), entries_.offsets.data(), MPI_DOUBLE, 0,
                communicator_.mpi());
    mumps_->a_loc = gathered_.data();
  }
  const int usual_space = mumps_->control(14);
  run(factorise);
  while (out_of_space() && mumps_->control(14) < 2000) {
    mumps_->control(14) *= 2;  // kept: later matrices of the run want it too
    run(factorise);
  }
  if (out_of_space()) {
    mumps_->control(14) = usual_space;
    throw SolveError("linear solver: MUMPS ran out of working space");
  }
}

void MumpsFactor::solve(const TpetraMultiVector& b, TpetraMultiVector& x) const {
  const auto& comm = communicator_.mpi();
  const int owned = rows_.counts[static_cast<std::size_t>(communicator_.rank())];
  const auto from = b.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto to = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t column = 0; column < b.getNumVectors(); ++column) {
    MPI_Gatherv(&from(0, column), owned, MPI_DOUBLE, whole_.data(), rows_.counts.data(),
                rows_.offsets.data(), MPI_DOUBLE, 0, comm);
    mumps_->rhs = whole_.data();
    mumps_->nrhs = 1;
    mumps_->lrhs = mumps_->n;
    run(substitute);
    if (out_of_space()) throw SolveError("linear solver: MUMPS ran out of working space");
    MPI_Scatterv(whole_.data(), rows_.counts.data(), rows_.offsets.data(), MPI_DOUBLE,
                 &to(0, column), owned, MPI_DOUBLE, 0, comm);
  }
}

}  // namespace hawser
