#pragma once
// Places in the plane, found again by where they are.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "hawser/base/types.hpp"

namespace hawser {

/// A vertex or the middle of a cell.
struct Place {
  std::array<double, 2> x;
  LocalIndex part, vertex;  // the vertex itself, or one of the cell's
};

/// Places in the boxes of a regular grid in the plane, about one in each.
class Boxes {
 public:
  /// At least one.
  explicit Boxes(std::vector<Place> places) : places_(std::move(places)) {
    std::array<double, 2> max = min_ = places_.front().x;
    for (const auto& place : places_)
      for (std::size_t j = 0; j < 2; ++j) {
        min_[j] = std::min(min_[j], place.x[j]);
        max[j] = std::max(max[j], place.x[j]);
      }
    number_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(places_.size()))) + 1;
    for (std::size_t j = 0; j < 2; ++j)
      size_[j] = std::max((max[j] - min_[j]) / static_cast<double>(number_), 1e-300);
    in_box_.resize(number_ * number_);
    for (std::size_t p = 0; p < places_.size(); ++p)
      in_box_[box(places_[p].x[0], 0) + number_ * box(places_[p].x[1], 1)].push_back(p);
  }

  /// Calls visit(place) for all that may be within the limits.
  template <class Visit>
  void within(const std::array<double, 2>& low, const std::array<double, 2>& high,
              Visit&& visit) const {
    for (auto j = box(low[1], 1); j <= box(high[1], 1); ++j)
      for (auto i = box(low[0], 0); i <= box(high[0], 0); ++i)
        for (const auto p : in_box_[i + number_ * j])
          visit(places_[p]);
  }

 private:
  std::size_t box(double x, std::size_t j) const {
    const double number = std::floor((x - min_[j]) / size_[j]);
    if (!(number > 0)) return 0;  // no number either: places beyond what a double can tell apart
    return static_cast<std::size_t>(std::min(number, static_cast<double>(number_ - 1)));
  }

  std::vector<Place> places_;
  std::array<double, 2> min_, size_;
  std::size_t number_;  // of boxes in each direction
  std::vector<std::vector<std::size_t>> in_box_;
};

}  // namespace hawser
