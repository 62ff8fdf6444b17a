#pragma once
// Parameters of a model from measured positions, by Gauss and Newton with differences.
//
// The positions of a streamer are off by far more than they are measured badly, and alike from shot
// to shot and from receiver to receiver: their errors are no 20000 independent ones. The covariance
//   sigma^2 (J^T J)^-1 n / n_independent
// counts as many as the residuals' correlations, along the line and along the cable, leave.
#include <functional>

#include "hawser/replay/comparison.hpp"
#include "hawser/replay/deck_of_line.hpp"

namespace hawser {

/// Positions for values of the fitted parameters, SI.
using ReplayModel = std::function<Positions(const std::vector<double>& values)>;

struct FitIteration {
  std::vector<double> values{};
  double rms = 0;  ///< m
};

struct FitResult {
  std::vector<double> values{}, standard_errors{};  ///< SI, per parameter
  std::vector<std::vector<double>> correlations{};  ///< of the errors of two
  std::vector<FitIteration> iterations{};
  Positions positions{};
  double independent = 0;  ///< places that count as measured independently
  bool converged = false;
  std::vector<bool> at_bound{};
};

/// Starts at `start`; `parameters` say how to take differences and what is allowed. `told` after
/// each iteration. An Error of the model at the start is the caller's; one on the way halves the
/// change.
FitResult fit_parameters(const MeasuredLine& line, const std::vector<ReplayParameter>& parameters,
                         std::vector<double> start, const ReplayModel& model,
                         const std::function<void(const FitIteration&)>& told);

/// How the positions answer to each of several parameters: the cosines between the changes that
/// two make, 1 or -1 for two that cannot be told apart. `positions` are those at `values`.
std::vector<std::vector<double>> likeness(const MeasuredLine& line, const Positions& positions,
                                          const std::vector<ReplayParameter>& parameters,
                                          const std::vector<double>& values,
                                          const ReplayModel& model);

/// Sentences for a person: what this line does not tell, or tells only together.
std::vector<std::string> what_cannot_be_told(const std::vector<ReplayParameter>& fitted,
                                             const FitResult& result,
                                             const std::vector<ReplayParameter>& all,
                                             const std::vector<std::vector<double>>& likeness);

}  // namespace hawser
