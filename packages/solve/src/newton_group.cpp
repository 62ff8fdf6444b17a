#include "newton_group.hpp"

#include <NOX_Thyra_Vector.H>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

namespace hawser {
namespace {

TpetraVector& unwrap(NOX::Abstract::Vector& vector) {
  auto& thyra = dynamic_cast<NOX::Thyra::Vector&>(vector);
  return *Thyra::TpetraOperatorVectorExtraction<double>::getTpetraVector(thyra.getThyraRCPVector());
}

const TpetraVector& unwrap(const NOX::Abstract::Vector& vector) {
  const auto& thyra = dynamic_cast<const NOX::Thyra::Vector&>(vector);
  return *Thyra::TpetraOperatorVectorExtraction<double>::getConstTpetraVector(
      thyra.getThyraRCPVector());
}

}  // namespace

NewtonGroup::Vector::Vector(const Teuchos::RCP<const TpetraMap>& map)
    : values(Teuchos::rcp(new TpetraVector(map))) {
  const Teuchos::RCP<Thyra::VectorBase<double>> thyra = Thyra::createVector(values);
  view = Teuchos::rcp(new NOX::Thyra::Vector(thyra));
}

NewtonGroup::NewtonGroup(Newton& newton, const TpetraVector& x)
    : newton_(newton),
      x_(x.getMap()),
      residual_(x.getMap()),
      update_(x.getMap()),
      magnitude_(Teuchos::rcp(new TpetraVector(x.getMap()))) {
  x_.values->update(1.0, x, 0.0);
  moved();
}

NewtonGroup::NewtonGroup(const NewtonGroup& source, NOX::CopyType type)
    : NewtonGroup(source.newton_, source.x()) {
  if (type == NOX::DeepCopy) *this = static_cast<const NOX::Abstract::Group&>(source);
}

void NewtonGroup::moved() {
  stamp_ = newton_.new_stamp();
  has_residual_ = false;
  has_update_ = false;
}

NOX::Abstract::Group& NewtonGroup::operator=(const NOX::Abstract::Group& other) {
  const auto& source = dynamic_cast<const NewtonGroup&>(other);
  if (&source == this) return *this;
  x_.values->update(1.0, source.x(), 0.0);
  stamp_ = source.stamp_;
  has_residual_ = source.has_residual_;
  has_update_ = source.has_update_;
  if (has_residual_) {
    residual_.values->update(1.0, source.residual(), 0.0);
    magnitude_->update(1.0, source.magnitude(), 0.0);
  }
  if (has_update_) update_.values->update(1.0, *source.update_.values, 0.0);
  return *this;
}

void NewtonGroup::setX(const NOX::Abstract::Vector& x) {
  x_.values->update(1.0, unwrap(x), 0.0);
  moved();
}

void NewtonGroup::computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction,
                           double step) {
  x_.values->update(1.0, unwrap(from.getX()), step, unwrap(direction), 0.0);
  moved();
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeF() {
  if (!has_residual_) newton_.compute_residual(x(), *residual_.values, *magnitude_);
  has_residual_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeJacobian() {
  newton_.compute_jacobian(x(), stamp_);
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeNewton(Teuchos::ParameterList&) {
  if (has_update_) return Ok;
  if (!isF() || !isJacobian()) return BadDependency;
  newton_.solve_linear(residual(), *update_.values);
  has_update_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::applyJacobian(const NOX::Abstract::Vector& input,
                                                            NOX::Abstract::Vector& result) const {
  if (!isJacobian()) return BadDependency;
  newton_.problem.system().matrix->apply(unwrap(input), unwrap(result));
  return Ok;
}

Teuchos::RCP<NOX::Abstract::Group> NewtonGroup::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new NewtonGroup(*this, type));
}

}  // namespace hawser
