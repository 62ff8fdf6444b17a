#pragma once
// One solve by one of NOX's solvers, stopped by the named blocks.
#include <NOX_StatusTest_Generic.H>
#include <Teuchos_ParameterList.hpp>

#include "newton_group.hpp"

namespace hawser {

/// For a solver that prints nothing.
Teuchos::RCP<Teuchos::ParameterList> quiet_parameters();

/// Moves the group to the solution by the solver that the parameters name. False when it has not
/// got there in so many iterations, or the further test, if any, has failed.
bool nox_solve(Newton& newton, const Teuchos::RCP<NewtonGroup>& group,
               const Teuchos::RCP<Teuchos::ParameterList>& parameters, int max_iterations,
               const Teuchos::RCP<NOX::StatusTest::Generic>& further = {});

}  // namespace hawser
