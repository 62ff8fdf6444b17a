#pragma once
// What must run before any matrix or vector is made.
#include <memory>

namespace hawser {

/// MPI, unless it runs already, and Kokkos, for as long as this object lives. One per process.
class Environment {
 public:
  Environment();
  ~Environment();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace hawser
