#include "hawser/fields/cell_locator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/base/tensor.hpp"
#include "src/cell_nodes.hpp"

namespace hawser {
namespace {

constexpr double tolerance = 1e-8;  // in the reference cell

Quadrature at_point(CellShape shape, const double* xi) {
  return {shape, 1, {1}, {xi, xi + traits(shape).dimension}};
}

Quadrature middle_of(CellShape shape) {
  const ShapeTraits& cell = traits(shape);
  double xi[3] = {};
  for (int k = 0; k < cell.dimension; ++k)
    for (int v = 0; v < cell.vertices; ++v)
      xi[k] += cell.vertex[v][k] / cell.vertices;
  return at_point(shape, xi);
}

bool is_inside(const ShapeTraits& cell, const double* xi) {
  double sum = 0;
  for (int k = 0; k < cell.dimension; ++k) {
    if (!(xi[k] >= -tolerance && xi[k] <= 1 + tolerance)) return false;
    sum += xi[k];
  }
  return !cell.simplex || sum <= 1 + tolerance;
}

}  // namespace

CellLocator::CellLocator(const DofMap& dofs, int moving)
    : dofs_(dofs),
      body_(dofs.mesh().body),
      moving_(moving),
      dimension_(static_cast<std::size_t>(dofs.mesh().dimension)) {
  const Basis basis =
      moving < 0 ? Basis::p1 : dofs.fields()[static_cast<std::size_t>(moving)].basis;
  middle_ = tabulate(basis, middle_of(body_.shape));
  nodes_ = static_cast<std::size_t>(middle_.nodes);
  for (LocalIndex cell = 0; cell < body_.size(); ++cell)
    if (body_.cell_owners[static_cast<std::size_t>(cell)] == dofs.mesh().communicator.rank())
      cells_.push_back(cell);
}

void CellLocator::move_to(const State& state) {
  if (placed_ && moving_ < 0) return;
  placed_ = true;
  const Mesh& mesh = dofs_.mesh();
  const auto vertices = static_cast<std::size_t>(traits(body_.shape).vertices);
  nodes_of_.assign(cells_.size() * nodes_ * dimension_, 0);
  low_.assign(cells_.size() * dimension_, std::numeric_limits<double>::max());
  high_.assign(low_.size(), std::numeric_limits<double>::lowest());
  std::vector<LocalIndex> rows;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    double* const x = &nodes_of_[i * nodes_ * dimension_];
    reference_nodes(mesh, body_, cells_[i], nodes_, dimension_, x);
    rows.clear();
    if (moving_ >= 0) dofs_.append_cell_rows(moving_, body_, cells_[i], rows);
    move_nodes(rows, state, dimension_, dimension_, x);
    // A bent edge goes a little beyond the box of its nodes.
    const double margin = nodes_ > vertices ? 0.25 : 1e-6;
    for (std::size_t j = 0; j < dimension_; ++j) {
      double& low = low_[i * dimension_ + j];
      double& high = high_[i * dimension_ + j];
      for (std::size_t a = 0; a < nodes_; ++a) {
        low = std::min(low, x[a * dimension_ + j]);
        high = std::max(high, x[a * dimension_ + j]);
      }
      const double size = high - low;
      low -= margin * size;
      high += margin * size;
    }
  }
  sort_into_bins();
}

void CellLocator::sort_into_bins() {
  origin_.assign(dimension_, std::numeric_limits<double>::max());
  std::vector<double> end(dimension_, std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < low_.size(); ++i) {
    origin_[i % dimension_] = std::min(origin_[i % dimension_], low_[i]);
    end[i % dimension_] = std::max(end[i % dimension_], high_[i]);
  }
  // About one cell each.
  const double count = std::pow(static_cast<double>(cells_.size()), 1.0 / double(dimension_));
  bins_.assign(dimension_, static_cast<std::size_t>(std::max(1.0, std::ceil(count))));
  width_.assign(dimension_, 1);
  std::size_t all = 1;
  for (std::size_t j = 0; j < dimension_; ++j) {
    if (!cells_.empty()) width_[j] = (end[j] - origin_[j]) / static_cast<double>(bins_[j]);
    all *= bins_[j];
  }
  in_bin_.assign(all, {});
  std::vector<std::size_t> first, last, now;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    bin(&low_[i * dimension_], first);
    bin(&high_[i * dimension_], last);
    // Over the block of bins from the first to the last.
    now = first;
    for (bool done = false; !done;) {
      std::size_t place = 0;
      for (std::size_t j = 0; j < dimension_; ++j)
        place = place * bins_[j] + now[j];
      in_bin_[place].push_back(i);
      std::size_t j = 0;
      while (j < dimension_ && ++now[j] > last[j]) {
        now[j] = first[j];
        ++j;
      }
      done = j == dimension_;
    }
  }
}

/// The bin of a place, the nearest one outside of all; `along` per dimension.
std::size_t CellLocator::bin(const double* x, std::vector<std::size_t>& along) const {
  along.assign(dimension_, 0);
  std::size_t place = 0;
  for (std::size_t j = 0; j < dimension_; ++j) {
    const double at = std::floor((x[j] - origin_[j]) / width_[j]);
    const auto most = static_cast<double>(bins_[j] - 1);
    along[j] = static_cast<std::size_t>(at > 0 ? std::min(at, most) : 0.0);
    place = place * bins_[j] + along[j];
  }
  return place;
}

std::optional<CellLocator::Place> CellLocator::find(const double* x) const {
  if (cells_.empty()) return std::nullopt;
  std::vector<std::size_t> along;
  for (const std::size_t i : in_bin_[bin(x, along)]) {
    bool in_box = true;
    for (std::size_t j = 0; j < dimension_; ++j)
      in_box = in_box && x[j] >= low_[i * dimension_ + j] && x[j] <= high_[i * dimension_ + j];
    Place place{cells_[i], {}};
    if (in_box && invert(static_cast<LocalIndex>(i), x, place.xi)) return place;
  }
  return std::nullopt;
}

/// Newton's method from the middle; of an affine cell its first step arrives.
bool CellLocator::invert(LocalIndex cell, const double* x, double* xi) const {
  const ShapeTraits& shape = traits(body_.shape);
  const double* const nodes = &nodes_of_[static_cast<std::size_t>(cell) * nodes_ * dimension_];
  const bool affine = shape.simplex && nodes_ == static_cast<std::size_t>(shape.vertices);
  const Quadrature middle = middle_of(body_.shape);
  std::copy(middle.locations.begin(), middle.locations.end(), xi);
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const Tabulation table =
        step == 0
            ? middle_
            : tabulate(nodes_ == static_cast<std::size_t>(shape.vertices) ? Basis::p1 : Basis::p2,
                       at_point(body_.shape, xi));
    Vector<double, 3> rest;
    Tensor<double, 3> jacobian;
    for (std::size_t j = 0; j < 3; ++j)
      jacobian(static_cast<int>(j), static_cast<int>(j)) = j < dimension_ ? 0 : 1;
    for (std::size_t j = 0; j < dimension_; ++j) {
      const int row = static_cast<int>(j);
      rest[row] = x[j];
      for (std::size_t a = 0; a < nodes_; ++a) {
        rest[row] -= table.values[a] * nodes[a * dimension_ + j];
        for (std::size_t k = 0; k < dimension_; ++k)
          jacobian(row, static_cast<int>(k)) +=
              table.gradients[a * dimension_ + k] * nodes[a * dimension_ + j];
      }
    }
    const Vector<double, 3> move = multiply(adjugate(jacobian), rest);
    const double volume = determinant(jacobian);
    double length = 0;
    for (std::size_t k = 0; k < dimension_; ++k) {
      xi[k] += move[static_cast<int>(k)] / volume;
      length = std::max(length, std::abs(move[static_cast<int>(k)] / volume));
    }
    if (!(length < 1e3)) return false;
    if (affine || length < 1e-12) return is_inside(shape, xi);
  }
  return false;
}

std::vector<double> CellLocator::box() const {
  const Communicator& communicator = dofs_.mesh().communicator;
  std::vector<double> low(dimension_, std::numeric_limits<double>::max()), high(dimension_);
  for (std::size_t j = 0; j < dimension_; ++j) {
    high[j] = std::numeric_limits<double>::lowest();
    for (std::size_t i = j; i < nodes_of_.size(); i += dimension_) {
      low[j] = std::min(low[j], nodes_of_[i]);
      high[j] = std::max(high[j], nodes_of_[i]);
    }
    low[j] = communicator.min(low[j]);
    high[j] = communicator.max(high[j]);
  }
  low.insert(low.end(), high.begin(), high.end());
  return low;
}

}  // namespace hawser
