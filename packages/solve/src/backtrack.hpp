#pragma once
// NOX's line search: the whole Newton step, halved while it leads out of what is admissible.
#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>

#include "newton.hpp"

namespace hawser {

class Backtrack : public NOX::LineSearch::Generic {
 public:
  explicit Backtrack(Newton& newton) : newton_(newton) {}
  bool compute(NOX::Abstract::Group& group, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;

 private:
  Newton& newton_;
};

class BacktrackFactory : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit BacktrackFactory(Newton& newton) : newton_(newton) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(const Teuchos::RCP<NOX::GlobalData>&,
                                                         Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new Backtrack(newton_));
  }

 private:
  Newton& newton_;
};

}  // namespace hawser
