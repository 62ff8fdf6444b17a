#pragma once
// Measured less modelled positions as one column of numbers, and how they answer to a parameter.
#include "hawser/replay/fit.hpp"

namespace hawser {

using Column = std::vector<double>;
using Matrix = std::vector<Column>;  // [row][column]

/// Measured minus model, [shot][receiver][east, north] without the missing ones.
Column residuals(const MeasuredLine& line, const Positions& model);

double dot(const Column& a, const Column& b);

/// d(model)/d(parameter), per unit of it, at the places that were measured; `at`: the residuals at
/// `values`, of which parameter `p` is changed.
Column difference(const MeasuredLine& line, const Column& at, const std::vector<double>& values,
                  std::size_t p, const ReplayParameter& parameter, const ReplayModel& model);

}  // namespace hawser
