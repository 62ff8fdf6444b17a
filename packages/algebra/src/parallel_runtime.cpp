#include "hawser/algebra/parallel_runtime.hpp"

#include <Tpetra_Core.hpp>

namespace hawser {

ParallelRuntime::ParallelRuntime() : started_here_(!Tpetra::isInitialized()) {
  int no_arguments = 0;  // the program's are not Kokkos'
  char** none = nullptr;
  if (started_here_) Tpetra::initialize(&no_arguments, &none);
}

ParallelRuntime::~ParallelRuntime() {
  if (started_here_) Tpetra::finalize();
}

}  // namespace hawser
