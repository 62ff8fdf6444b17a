#include "src/formula_functions.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/deck/ramp.hpp"
#include "src/formula.hpp"

namespace hawser {
namespace {

constexpr double ln_2 = 0.69314718055994530942, ln_10 = 2.30258509299404568402;

double sign(double u) { return u < 0 ? -1 : u > 0 ? 1 : 0; }
double rounded(double u) { return std::floor(u + 0.5); }
double zero(double, double) { return 0; }
double inverse(double u, double) { return 1 / u; }

/// Where two are equally extreme, the first counts.
template <class Compare>
double extreme(const double* u, int count, double* slopes, Compare compare) {
  const double* const found = std::min_element(u, u + count, compare);
  if (slopes != nullptr) {
    std::fill_n(slopes, count, 0.0);
    slopes[found - u] = 1;
  }
  return *found;
}
double least(const double* u, int count, double* slopes) {
  return extreme(u, count, slopes, [](double a, double b) { return a < b; });
}
double greatest(const double* u, int count, double* slopes) {
  return extreme(u, count, slopes, [](double a, double b) { return a > b; });
}

double sum(const double* u, int count, double* slopes) {
  double result = 0;
  for (int k = 0; k < count; ++k)
    result += u[k];
  if (slopes != nullptr) std::fill_n(slopes, count, 1.0);
  return result;
}
double average(const double* u, int count, double* slopes) {
  const double result = sum(u, count, nullptr) / count;
  if (slopes != nullptr) std::fill_n(slopes, count, 1.0 / count);
  return result;
}

double arc(const double* u, int, double* slopes) {
  if (slopes != nullptr) {
    const double square = u[0] * u[0] + u[1] * u[1];
    slopes[0] = u[1] / square;
    slopes[1] = -u[0] / square;
  }
  return std::atan2(u[0], u[1]);
}

double power(const double* u, int, double* slopes) {
  const double value = std::pow(u[0], u[1]);
  if (slopes != nullptr) {
    slopes[0] = u[1] == 0 ? 0 : u[1] * std::pow(u[0], u[1] - 1);
    slopes[1] = value == 0 ? 0 : value * std::log(u[0]);
  }
  return value;
}

// u: time, start, duration.
double ramped(const double* u, int, double* slopes) {
  if (slopes != nullptr) {
    const bool between = u[0] > u[1] && u[0] < u[1] + u[2];
    const double s = between ? (u[0] - u[1]) / u[2] : 0;
    slopes[0] = between ? 30 * s * s * (1 - s) * (1 - s) / u[2] : 0;
    slopes[1] = -slopes[0];
    slopes[2] = -s * slopes[0];
  }
  return ramp(u[0], u[1], u[2]);
}
double ramped_distance(const double* u, int, double* slopes) {
  const double way = ramp_distance(u[0], u[1], u[2]);
  if (slopes != nullptr) {
    slopes[0] = ramp(u[0], u[1], u[2]);
    slopes[1] = -slopes[0];
    const double time = u[0] - u[1];
    if (time <= 0)
      slopes[2] = 0;
    else
      slopes[2] = slopes[0] == 1 ? -0.5 : (way - time * slopes[0]) / u[2];
  }
  return way;
}

FormulaFunction of_several(const char* name, int least_count, int most_count,
                           double (*value)(const double*, int, double*)) {
  return {name, least_count, most_count, nullptr, nullptr, value};
}
FormulaFunction of_one(const char* name, double (*value)(double), double (*slope)(double, double)) {
  return {name, 1, 1, value, slope, nullptr};
}

}  // namespace

const FormulaFunction power_function = of_several("^", 2, 2, power);

const std::vector<FormulaFunction>& formula_functions() {
  constexpr int many = Formula::deepest;
  static const std::vector<FormulaFunction> functions = {
      of_one("abs", std::fabs, [](double u, double) { return sign(u); }),
      of_one("acos", std::acos, [](double u, double) { return -1 / std::sqrt((1 - u) * (1 + u)); }),
      of_one("acosh", std::acosh,
             [](double u, double) { return 1 / std::sqrt((u - 1) * (u + 1)); }),
      of_one("asin", std::asin, [](double u, double) { return 1 / std::sqrt((1 - u) * (1 + u)); }),
      of_one("asinh", std::asinh, [](double u, double) { return 1 / std::sqrt(u * u + 1); }),
      of_one("atan", std::atan, [](double u, double) { return 1 / (1 + u * u); }),
      of_several("atan2", 2, 2, arc),
      of_one("atanh", std::atanh, [](double u, double) { return 1 / ((1 - u) * (1 + u)); }),
      of_several("avg", 1, many, average),
      of_one("cos", std::cos, [](double u, double) { return -std::sin(u); }),
      of_one("cosh", std::cosh, [](double u, double) { return std::sinh(u); }),
      of_one("exp", std::exp, [](double, double f) { return f; }),
      of_one("ln", std::log, inverse),
      of_one("log", std::log, inverse),
      of_one("log10", std::log10, [](double u, double) { return 1 / (u * ln_10); }),
      of_one("log2", std::log2, [](double u, double) { return 1 / (u * ln_2); }),
      of_several("max", 1, many, greatest),
      of_several("min", 1, many, least),
      of_several("ramp", 3, 3, ramped),
      of_several("ramp_distance", 3, 3, ramped_distance),
      of_one("rint", rounded, zero),
      of_one("sign", sign, zero),
      of_one("sin", std::sin, [](double u, double) { return std::cos(u); }),
      of_one("sinh", std::sinh, [](double u, double) { return std::cosh(u); }),
      of_one("sqrt", std::sqrt, [](double, double f) { return 0.5 / f; }),
      of_several("sum", 1, many, sum),
      of_one("tan", std::tan, [](double, double f) { return 1 + f * f; }),
      of_one("tanh", std::tanh, [](double u, double) { return 1 / (std::cosh(u) * std::cosh(u)); }),
  };
  return functions;
}

}  // namespace hawser
