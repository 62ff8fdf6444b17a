#pragma once
#include "hawser/values/value_source.hpp"

namespace hawser {

/// A number or formula per component.
class ExpressionSource : public ValueSource {
 public:
  explicit ExpressionSource(Expressions formulas) : formulas_(std::move(formulas)) {}

  int components() const override { return static_cast<int>(formulas_.size()); }
  void value(const SpaceTime& at, double* values) const override;
  void time_derivative(const SpaceTime& at, double* rates) const override;
  void gradient(const SpaceTime& at, int component, double* slope) const override;
  bool depends_on_moved_position(int component) const override;
  using ValueSource::depends_on_moved_position;

 private:
  Expressions formulas_;
};

}  // namespace hawser
