#include "src/formula.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

bool is_number(const Formula::Step& step) { return step.operation == Formula::Operation::number; }

void load(double& value, double given, int /*direction*/) { value = given; }
void load(Dual& value, double given, int direction) {
  value = given;
  if (direction >= 0 && direction < Dual::directions) value.slope[direction] = 1;
}

void call_one(double& u, const FormulaFunction& function) { u = function.value(u); }
void call_one(Dual& u, const FormulaFunction& function) {
  const double f = function.value(u.value);
  u.become(f, function.slope(u.value, f));
}

void call(double* u, int count, const FormulaFunction& function) {
  *u = function.of_several(u, count, nullptr);
}
void call(Dual* u, int count, const FormulaFunction& function) {
  double values[Formula::deepest], slopes[Formula::deepest];
  for (int k = 0; k < count; ++k)
    values[k] = u[k].value;
  const double f = function.of_several(values, count, slopes);
  u->become(f, slopes[0]);
  for (int k = 1; k < count; ++k)
    u->become(f, 1, u[k], slopes[k]);
}

double multiplied_out(double u, int exponent) {
  double power = u;
  for (int k = 1; k < exponent; ++k)
    power *= u;
  return power;
}
void raise(double& u, int exponent) { u = multiplied_out(u, exponent); }
void raise(Dual& u, int exponent) {
  u.become(multiplied_out(u.value, exponent), exponent * multiplied_out(u.value, exponent - 1));
}

}  // namespace

void Formula::append(const Step& step) {
  if (step.variable != nullptr) used_ += step.variable->name;
  steps_.push_back(step);
  waiting_ += 1 - step.operands;
  depth_ = std::max(depth_, waiting_);
  const auto first = steps_.end() - 1 - step.operands;
  if (step.operands == 0 || !std::all_of(first, steps_.end() - 1, is_number)) return;
  Formula known;
  known.steps_.assign(first, steps_.end());
  const double value = known.value({});
  steps_.erase(first, steps_.end());
  steps_.push_back({Operation::number, 0, value});
}

void Formula::append_power() {
  const double exponent = is_number(steps_.back()) ? steps_.back().number : 0;
  if (exponent != 2 && exponent != 3 && exponent != 4) {
    append({Operation::function, 2, 0, nullptr, &power_function});
    return;
  }
  steps_.pop_back();
  --waiting_;
  append({Operation::whole_power, 1, exponent});
}

bool Formula::uses_any(const std::string& variables) const {
  return used_.find_first_of(variables) != std::string::npos;
}

int Formula::degree(int place, const std::vector<int>& references) const {
  constexpr int none = 1000;  // of no polynomial: more than any sum of a formula's degrees
  std::vector<int> stack;
  for (const Step& step : steps_) {
    const std::size_t first = stack.size() - static_cast<std::size_t>(step.operands);
    const int a = step.operands > 0 ? stack[first] : 0,
              b = step.operands > 1 ? stack[first + 1] : 0;
    const bool constant = std::all_of(stack.begin() + static_cast<std::ptrdiff_t>(first),
                                      stack.end(), [](int degree) { return degree == 0; });
    int result = constant ? 0 : none;
    switch (step.operation) {
      case Operation::variable: result = step.variable->name == 't' ? 0 : place; break;
      case Operation::reference: result = references[static_cast<std::size_t>(step.number)]; break;
      case Operation::negate: result = a; break;
      case Operation::add:
      case Operation::subtract: result = std::max(a, b); break;
      case Operation::multiply: result = a + b; break;
      case Operation::divide:
        if (b == 0) result = a;
        break;
      case Operation::whole_power: result = a * static_cast<int>(step.number); break;
      default: break;
    }
    stack.resize(first);
    stack.push_back(std::min(result, none));
  }
  return stack.front() >= none ? -1 : stack.front();
}

template <class T>
T Formula::run(const SpaceTime& at, const double* references, int first) const {
  T stack[deepest];
  T* top = stack;  // past the last value
  for (const Step& step : steps_) {
    // Operands are top[0], top[1], top[2]; the result replaces the first.
    top -= step.operands;
    switch (step.operation) {
      case Operation::number: *top = step.number; break;
      case Operation::variable:
        load(*top, at.*step.variable->member, step.variable->direction - first);
        break;
      case Operation::reference: {
        const int index = static_cast<int>(step.number);
        load(*top, references[index], Dual::directions + index - first);
        break;
      }
      case Operation::negate: negate(*top); break;
      case Operation::add: top[0] += top[1]; break;
      case Operation::subtract: top[0] -= top[1]; break;
      case Operation::multiply: top[0] *= top[1]; break;
      case Operation::divide: top[0] /= top[1]; break;
      case Operation::whole_power: raise(*top, static_cast<int>(step.number)); break;
      case Operation::less: *top = double(value_of(top[0]) < value_of(top[1])); break;
      case Operation::greater: *top = double(value_of(top[0]) > value_of(top[1])); break;
      case Operation::at_most: *top = double(value_of(top[0]) <= value_of(top[1])); break;
      case Operation::at_least: *top = double(value_of(top[0]) >= value_of(top[1])); break;
      case Operation::equal: *top = double(value_of(top[0]) == value_of(top[1])); break;
      case Operation::unequal: *top = double(value_of(top[0]) != value_of(top[1])); break;
      case Operation::both: *top = double(value_of(top[0]) != 0 && value_of(top[1]) != 0); break;
      case Operation::either: *top = double(value_of(top[0]) != 0 || value_of(top[1]) != 0); break;
      case Operation::choose: *top = value_of(top[0]) != 0 ? top[1] : top[2]; break;
      case Operation::function_of_one: call_one(*top, *step.function); break;
      case Operation::function: call(top, step.operands, *step.function); break;
    }
    ++top;
  }
  return stack[0];
}

template double Formula::run<double>(const SpaceTime&, const double*, int) const;
template Dual Formula::run<Dual>(const SpaceTime&, const double*, int) const;

}  // namespace hawser
