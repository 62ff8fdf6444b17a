#pragma once
// Masses in a row between springs, implicitly in time: per node a velocity and a displacement,
//
//   m v_i + k (2 d_i - d_i-1 - d_i+1) = f_i,   d_i - c v_i = r_i,
//
// stiff enough that the springs carry all: k c >> m.
#include <Tpetra_Core.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include "hawser/algebra/block_system.hpp"

namespace hawser::test {

class SpringChain {
 public:
  static constexpr double mass = 1, spring = 1e6, step = 0.1;

  explicit SpringChain(int nodes) {
    const auto comm = Tpetra::getDefaultComm();
    const GlobalIndex first = static_cast<GlobalIndex>(nodes) * comm->getRank() / comm->getSize();
    const GlobalIndex last =
        static_cast<GlobalIndex>(nodes) * (comm->getRank() + 1) / comm->getSize();
    system.rows =
        Teuchos::rcp(new TpetraMap(static_cast<Tpetra::global_size_t>(2 * nodes),
                                   static_cast<std::size_t>(2 * (last - first)), 0, comm));
    system.matrix = Teuchos::rcp(new TpetraMatrix(system.rows, 8));
    RowLayout& layout = system.layout;
    for (GlobalIndex node = first; node < last; ++node) {
      const GlobalIndex v = 2 * node, d = v + 1;
      const auto insert = [&](GlobalIndex row, GlobalIndex column, double value) {
        system.matrix->insertGlobalValues(row, 1, &value, &column);
      };
      insert(v, v, mass);
      insert(v, d, 2 * spring);
      for (const GlobalIndex other : {node - 1, node + 1}) {
        if (other < 0 || other >= nodes) continue;
        insert(v, 2 * other, 0);
        insert(v, 2 * other + 1, -spring);
      }
      insert(d, d, 1);
      insert(d, v, -step);
      layout.group.insert(layout.group.end(), {0, RowLayout::follows});
      layout.node.insert(layout.node.end(), 2, static_cast<LocalIndex>(node - first));
      layout.kind.insert(layout.kind.end(), {0, 1});
      layout.positions.push_back(static_cast<double>(node));
    }
    system.matrix->fillComplete();
    system.columns = system.matrix->getColMap();
    layout.groups = {{"chain"}};
    layout.dimension = 1;
    layout.kinds = 2;
    layout.factor = step;
    layout.prescribed.assign(layout.group.size(), 0);
    for (LocalIndex column = 0;
         column < static_cast<LocalIndex>(system.columns->getNodeNumElements()); ++column) {
      const GlobalIndex number = system.columns->getGlobalElement(column);
      if (number % 2 == 1)
        layout.followers.push_back({column, system.columns->getLocalElement(number - 1)});
    }
  }

  /// The first node's velocity and displacement are given from now on.
  void hold_end() {
    if (system.communicator.is_root())
      for (const LocalIndex row : {0, 1}) {
        const auto local = system.matrix->getLocalMatrixHost();
        for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k)
          local.values(k) = local.graph.entries(k) == row ? 1 : 0;
        system.layout.prescribed[static_cast<std::size_t>(row)] = 1;
      }
  }

  BlockSystem system;
};

}  // namespace hawser::test
