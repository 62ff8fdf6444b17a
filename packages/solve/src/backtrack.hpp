#pragma once
// NOX's line search: the whole Newton step, halved while it leads out of what is admissible.
#include <NOX_LineSearch_Generic.H>
#include <Teuchos_ParameterList.hpp>

#include "newton_group.hpp"

namespace hawser {

class Backtrack : public NOX::LineSearch::Generic {
 public:
  /// As NOX' factory wants it: "Newton" in its parameters is a Newton*.
  Backtrack(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList& parameters)
      : newton_(*parameters.get<Newton*>("Newton")) {}
  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

 private:
  bool is_acceptable(const NewtonGroup& start, const NewtonGroup& trial);

  Newton& newton_;
  double first_norm_ = -1;  ///< row-scaled, of the solve's first residual; -1: none yet
};

}  // namespace hawser
