#pragma once
// One iterate with its residual, magnitude and Newton update, as NOX sees it.
#include <NOX_Abstract_Group.H>

#include "newton.hpp"

namespace hawser {

class NewtonGroup : public NOX::Abstract::Group {
 public:
  NewtonGroup(Newton& newton, const TpetraVector& x);

  const TpetraVector& x() const { return *x_.values; }
  const TpetraVector& residual() const { return *residual_.values; }
  const TpetraVector& magnitude() const { return *magnitude_; }
  const std::vector<BlockNorm>& norms() const;  ///< after computeF()
  void estimate_errors();                       ///< in these norms

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;
  void setX(const NOX::Abstract::Vector& x) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction,
                double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeNewton(Teuchos::ParameterList& linear) override;
  /// Anderson's fixed-point update, -J^-1 input with the last Jacobian; 0 where all is in balance.
  ReturnType applyRightPreconditioning(bool transposed, Teuchos::ParameterList& unused,
                                       const NOX::Abstract::Vector& input,
                                       NOX::Abstract::Vector& result) const override;

  bool isF() const override { return has_residual_; }
  bool isJacobian() const override { return has_jacobian_; }
  const NOX::Abstract::Vector& getX() const override { return *x_.view; }
  const NOX::Abstract::Vector& getF() const override { return *residual_.view; }
  double getNormF() const override { return newton_.linear.scaled_norm(residual()); }
  const NOX::Abstract::Vector& getGradient() const override {
    return *update_.view;
  }  // never asked
  const NOX::Abstract::Vector& getNewton() const override { return *update_.view; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_.view; }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return residual_.view; }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return update_.view; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return update_.view; }
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;

 private:
  /// A Tpetra vector, and NOX's view of the same values.
  struct Vector {
    explicit Vector(const Teuchos::RCP<const TpetraMap>& map);
    Teuchos::RCP<TpetraVector> values;
    Teuchos::RCP<NOX::Abstract::Vector> view;
  };
  void moved();  ///< to another iterate

  Newton& newton_;
  Vector x_, residual_, update_;
  Teuchos::RCP<TpetraVector> magnitude_;
  mutable std::vector<BlockNorm> norms_;  ///< empty: not known
  bool has_residual_ = false;
  bool has_jacobian_ = false;
};

}  // namespace hawser
