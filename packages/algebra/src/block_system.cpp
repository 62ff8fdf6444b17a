#include "hawser/algebra/block_system.hpp"

#include <Tpetra_CrsMatrix.hpp>

namespace hawser {

double BlockSystem::entries() const { return static_cast<double>(matrix->getGlobalNumEntries()); }

}  // namespace hawser
