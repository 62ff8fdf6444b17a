#include "hawser/base/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace hawser {

double exact_sum(const Communicator& communicator, const std::vector<double>& terms) {
  double largest = 0;
  bool finite = true;
  for (const double term : terms) {
    finite = finite && std::isfinite(term);
    largest = std::max(largest, std::abs(term));
  }
  if (communicator.any(!finite)) return std::numeric_limits<double>::quiet_NaN();
  largest = communicator.max(largest);
  if (largest == 0) return 0;

  // In units of 2^90, 2^45 and 1 of the smallest that counts; what is above 2^45 is carried over,
  // so that any number of terms fits, and 2^17 ranks.
  constexpr int bits = 45;
  constexpr std::int64_t base = std::int64_t{1} << bits;
  const int exponent = std::ilogb(largest) + 1;
  std::int64_t parts[3] = {};
  const auto carry = [&] {
    for (const int k : {2, 1}) {
      std::int64_t over = parts[k] / base;
      if (parts[k] < over * base) --over;  // what stays is not negative: one way to write a sum
      parts[k] -= over * base;
      parts[k - 1] += over;
    }
  };
  for (const double term : terms) {
    const double scaled = std::ldexp(term, bits - exponent);
    const double high = std::rint(scaled);
    parts[1] += static_cast<std::int64_t>(high);
    parts[2] += static_cast<std::int64_t>(std::rint(std::ldexp(scaled - high, bits)));
    carry();
  }
  MPI_Allreduce(MPI_IN_PLACE, parts, 3, MPI_INT64_T, MPI_SUM, communicator.mpi());
  carry();
  const bool negative = parts[0] < 0;
  if (negative) {
    for (std::int64_t& part : parts)
      part = -part;
    carry();
  }
  // From the small end, nothing cancels.
  double sum = 0;
  for (const int k : {2, 1, 0})
    sum += std::ldexp(static_cast<double>(parts[k]), exponent - k * bits);
  return negative ? -sum : sum;
}

}  // namespace hawser
