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
}

void NewtonGroup::moved() {
  norms_.clear();
  has_residual_ = has_jacobian_ = false;
}

const std::vector<BlockNorm>& NewtonGroup::norms() const {
  if (norms_.empty()) norms_ = newton_.norms(residual(), magnitude());
  return norms_;
}

void NewtonGroup::estimate_errors() {
  norms();
  newton_.estimate_errors(x(), residual(), norms_);
}

NOX::Abstract::Group& NewtonGroup::operator=(const NOX::Abstract::Group& other) {
  const auto& source = dynamic_cast<const NewtonGroup&>(other);
  setX(source.getX());
  residual_.values->update(1.0, source.residual(), 0.0);
  magnitude_->update(1.0, source.magnitude(), 0.0);
  has_residual_ = source.has_residual_;
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
  if (has_jacobian_) return Ok;
  newton_.compute_jacobian(x());
  norms_.clear();  // what counts as round-off follows from the Jacobian
  has_jacobian_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::computeNewton(Teuchos::ParameterList& linear) {
  newton_.compute_update(residual(), *update_.values, linear.get<double>("Tolerance"));
  return Ok;
}

NOX::Abstract::Group::ReturnType NewtonGroup::applyRightPreconditioning(
    bool, Teuchos::ParameterList&, const NOX::Abstract::Vector& input,
    NOX::Abstract::Vector& result) const {
  if (newton_.balanced(norms()))
    result.init(0);
  else
    newton_.approximate_update(unwrap(input), unwrap(result));
  return Ok;
}

Teuchos::RCP<NOX::Abstract::Group> NewtonGroup::clone(NOX::CopyType type) const {
  const auto copy = Teuchos::rcp(new NewtonGroup(newton_, x()));
  if (type == NOX::DeepCopy) *copy = static_cast<const NOX::Abstract::Group&>(*this);
  return copy;
}

}  // namespace hawser
