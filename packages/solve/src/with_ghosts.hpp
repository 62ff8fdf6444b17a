#pragma once
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Vector.hpp>

#include "hawser/algebra/tpetra_fwd.hpp"

namespace hawser {

/// `all`, on the matrix' columns, becomes what `owned` has on all ranks. Collective.
inline void with_ghosts(const TpetraMatrix& matrix, const TpetraVector& owned, TpetraVector& all) {
  const auto importer = matrix.getGraph()->getImporter();
  if (importer.is_null())
    all.update(1.0, owned, 0.0);
  else
    all.doImport(owned, *importer, Tpetra::INSERT);
}

}  // namespace hawser
