#include "reaction_transport.hpp"

#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include <cmath>

namespace hawser::test {
namespace {

constexpr double units[2] = {1e3, 1e-3};

double exact_value(int field, double x, double y) {
  const double bump = x * (1 - x) * y * (1 - y);
  return field == 0 ? 24 * bump : 300 * bump * x;
}

/// Neighbours of node (i, j) in the order here, west, east, south, north; -1 beyond the edge.
void neighbours(GlobalIndex node, int side, GlobalIndex result[5]) {
  const auto i = node % side;
  const auto j = node / side;
  result[0] = node;
  result[1] = i > 0 ? node - 1 : -1;
  result[2] = i + 1 < side ? node + 1 : -1;
  result[3] = j > 0 ? node - side : -1;
  result[4] = j + 1 < side ? node + side : -1;
}

}  // namespace

ReactionTransport::ReactionTransport(int nodes_per_side, double lambda)
    : side_(nodes_per_side), lambda_(lambda) {
  make_system();
  make_stencils();
}

void ReactionTransport::make_system() {
  const auto comm = Tpetra::getDefaultComm();
  const GlobalIndex nodes = static_cast<GlobalIndex>(side_) * side_;
  const GlobalIndex first = nodes * comm->getRank() / comm->getSize();
  const GlobalIndex last = nodes * (comm->getRank() + 1) / comm->getSize();
  const auto owned = static_cast<std::size_t>(2 * (last - first));
  system_.rows =
      Teuchos::rcp(new TpetraMap(static_cast<Tpetra::global_size_t>(2 * nodes), owned, 0, comm));
  const auto graph = Teuchos::rcp(new Tpetra::CrsGraph<>(system_.rows, 10));
  for (GlobalIndex node = first; node < last; ++node) {
    GlobalIndex near[5];
    neighbours(node, side_, near);
    std::vector<GlobalIndex> columns;
    for (const auto other : near) {
      if (other < 0) continue;
      columns.push_back(2 * other);
      columns.push_back(2 * other + 1);
    }
    for (const int field : {0, 1})
      graph->insertGlobalIndices(2 * node + field, columns);
  }
  graph->fillComplete();
  system_.columns = graph->getColMap();
  system_.matrix = Teuchos::rcp(new TpetraMatrix(graph));
  system_.matrix->fillComplete();
  system_.blocks = {{"heat", "temperature", "W", {}}, {"chemistry", "concentration", "mol/s", {}}};
  for (LocalIndex row = 0; row < static_cast<LocalIndex>(owned); ++row)
    system_.blocks[static_cast<std::size_t>(row % 2)].rows.push_back(row);
}

void ReactionTransport::make_stencils() {
  for (const LocalIndex row : system_.blocks[0].rows) {
    GlobalIndex near[5];
    neighbours(system_.rows->getGlobalElement(row) / 2, side_, near);
    Stencil stencil;
    for (const int field : {0, 1})
      for (int k = 0; k < 5; ++k)
        stencil.columns[field][k] =
            near[k] < 0 ? -1 : system_.columns->getLocalElement(2 * near[k] + field);
    stencils_.push_back(stencil);
  }
}

TpetraVector ReactionTransport::with_ghosts(const TpetraVector& x) const {
  TpetraVector result(system_.columns);
  result.doImport(x, Tpetra::Import<>(system_.rows, system_.columns), Tpetra::INSERT);
  return result;
}

TpetraVector ReactionTransport::exact() const {
  TpetraVector x(system_.rows);
  const double h = 1.0 / (side_ + 1);
  for (std::size_t i = 0; i < stencils_.size(); ++i) {
    const auto node = system_.rows->getGlobalElement(static_cast<LocalIndex>(2 * i)) / 2;
    const auto at_x = h * static_cast<double>(node % side_ + 1);
    const auto at_y = h * static_cast<double>(node / side_ + 1);
    for (const int field : {0, 1})
      x.replaceLocalValue(static_cast<LocalIndex>(2 * i) + field, exact_value(field, at_x, at_y));
  }
  return x;
}

ReactionTransport::Terms ReactionTransport::terms(std::size_t node,
                                                  const TpetraVector& ghosted) const {
  const auto values = ghosted.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto value = [&](int field, int k) {
    const auto column = stencils_[node].columns[field][k];
    return column < 0 ? 0.0 : values(column, 0);
  };
  const double h = 1.0 / (side_ + 1);
  Terms result{};
  for (const int field : {0, 1}) {
    auto& sum = result.values[field];
    sum[0] = 4 * value(field, 0) / (h * h);
    for (int k = 1; k < 5; ++k)
      sum[k] = -value(field, k) / (h * h);
    if (field == 0) {
      sum[5] = -lambda_ * std::exp(value(0, 0));
      sum[6] = value(1, 0);
    } else {
      const double carried = speed + value(0, 0);
      sum[5] = carried * value(1, 0) / h;  // upwind
      sum[6] = -carried * value(1, 1) / h;
    }
    for (double& term : sum)
      term *= units[field];
  }
  return result;
}

void ReactionTransport::residual(const TpetraVector& x, TpetraVector& f, TpetraVector& magnitude) {
  const auto now = with_ghosts(x);
  const auto solved = with_ghosts(exact());
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const auto here = terms(node, now);
    const auto there = terms(node, solved);
    for (const int field : {0, 1}) {
      double sum = 0, size = 0, source = 0;
      for (const double term : there.values[field])
        source += term;
      for (const double term : here.values[field]) {
        sum += term;
        size += std::abs(term);
      }
      const auto row = static_cast<LocalIndex>(2 * node) + field;
      f.replaceLocalValue(row, sum - source);
      magnitude.replaceLocalValue(row, size + std::abs(source));
    }
  }
}

void ReactionTransport::jacobian(const TpetraVector& x) {
  auto& matrix = *system_.matrix;
  const auto ghosted = with_ghosts(x);
  const auto values = ghosted.getLocalViewHost(Tpetra::Access::ReadOnly);
  const double h = 1.0 / (side_ + 1);
  matrix.resumeFill();
  matrix.setAllToScalar(0.0);
  for (std::size_t node = 0; node < stencils_.size(); ++node) {
    const auto& columns = stencils_[node].columns;
    const auto add = [&](int field, LocalIndex column, double value) {
      const double scaled = units[field] * value;
      if (column >= 0)
        matrix.sumIntoLocalValues(static_cast<LocalIndex>(2 * node) + field, 1, &scaled, &column);
    };
    for (const int field : {0, 1}) {
      add(field, columns[field][0], 4 / (h * h));
      for (int k = 1; k < 5; ++k)
        add(field, columns[field][k], -1 / (h * h));
    }
    const double u = values(columns[0][0], 0);
    const double west = columns[1][1] < 0 ? 0.0 : values(columns[1][1], 0);
    add(0, columns[0][0], -lambda_ * std::exp(u));
    add(0, columns[1][0], 1);
    add(1, columns[1][0], (speed + u) / h);
    add(1, columns[1][1], -(speed + u) / h);
    add(1, columns[0][0], (values(columns[1][0], 0) - west) / h);
  }
  matrix.fillComplete(system_.rows, system_.rows);
}

}  // namespace hawser::test
