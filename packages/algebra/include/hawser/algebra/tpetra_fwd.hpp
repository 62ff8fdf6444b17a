#pragma once
// The Tpetra types of the one instantiation that Debian's Trilinos has, without their headers.
#include <Teuchos_RCPDecl.hpp>
#include <Tpetra_CrsMatrix_fwd.hpp>
#include <Tpetra_Map_fwd.hpp>
#include <Tpetra_MultiVector_fwd.hpp>
#include <Tpetra_Operator_fwd.hpp>
#include <Tpetra_Vector_fwd.hpp>

namespace hawser {

using TpetraMap = Tpetra::Map<>;
using TpetraMatrix = Tpetra::CrsMatrix<>;
using TpetraVector = Tpetra::Vector<>;
using TpetraMultiVector = Tpetra::MultiVector<>;
using TpetraOperator = Tpetra::Operator<>;

}  // namespace hawser
