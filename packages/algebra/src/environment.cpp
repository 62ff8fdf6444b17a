#include "hawser/algebra/environment.hpp"

#include <Tpetra_Core.hpp>

namespace hawser {

struct Environment::Implementation {
  int no_arguments = 0;  // the program's are not Kokkos'
  char** none = nullptr;
  Tpetra::ScopeGuard tpetra{&no_arguments, &none};
};

Environment::Environment() : implementation_(std::make_unique<Implementation>()) {}
Environment::~Environment() = default;

}  // namespace hawser
