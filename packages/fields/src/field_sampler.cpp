#include "hawser/fields/field_sampler.hpp"

#include <algorithm>

#include "hawser/element/cell_geometry.hpp"
#include "src/cell_nodes.hpp"

namespace hawser {

FieldSampler::FieldSampler(const DofMap& dofs, const Region& region, Quadrature points,
                           const std::vector<int>& fields, int moving)
    : dofs_(dofs),
      region_(region),
      points_(std::move(points)),
      geometry_(tabulate(
          moving < 0 ? Basis::p1 : dofs.fields()[static_cast<std::size_t>(moving)].basis, points_)),
      moving_(moving) {
  for (const int index : fields) {
    const FieldDescription& field = dofs.fields()[static_cast<std::size_t>(index)];
    fields_.push_back({index,
                       static_cast<std::size_t>(field.components),
                       tabulate(field.basis, points_),
                       {},
                       true});
  }
}

void FieldSampler::gather(Field& field, LocalIndex cell, const State& state) {
  rows_.clear();
  dofs_.append_cell_rows(field.index, region_, cell, rows_);
  field.values.assign(rows_.size() * field.components, 0);
  field.lives = std::find(rows_.begin(), rows_.end(), -1) == rows_.end();
  for (std::size_t a = 0; a < rows_.size(); ++a)
    for (std::size_t c = 0; rows_[a] >= 0 && c < field.components; ++c)
      field.values[a * field.components + c] = state.value[static_cast<std::size_t>(rows_[a]) + c];
}

void FieldSampler::enter(LocalIndex cell, const State& state) {
  constexpr std::size_t stride = 3;
  const auto dimension = static_cast<std::size_t>(dofs_.mesh().dimension);
  const auto nodes = static_cast<std::size_t>(geometry_.nodes);
  reference_.assign(stride * nodes, 0);
  reference_nodes(dofs_.mesh(), region_, cell, nodes, stride, reference_.data());
  moved_ = reference_;
  rows_.clear();
  if (moving_ >= 0) dofs_.append_cell_rows(moving_, region_, cell, rows_);
  move_nodes(rows_, state, dimension, stride, moved_.data());
  for (Field& field : fields_)
    gather(field, cell, state);
  place_.t = state.time;
}

void FieldSampler::go_to(int point) {
  point_ = static_cast<std::size_t>(point);
  const int dimension = traits(region_.shape).dimension;
  const auto nodes = static_cast<std::size_t>(geometry_.nodes);
  const double* const N = &geometry_.values[point_ * nodes];
  const double* const slope =
      &geometry_.gradients[point_ * nodes * static_cast<std::size_t>(dimension)];
  double X[3] = {}, x[3] = {};
  jacobian_ = {};
  for (std::size_t a = 0; a < nodes; ++a)
    for (int j = 0; j < 3; ++j) {
      const std::size_t i = 3 * a + static_cast<std::size_t>(j);
      X[j] += N[a] * reference_[i];
      x[j] += N[a] * moved_[i];
      for (int k = 0; k < dimension; ++k)
        jacobian_(j, k) +=
            slope[a * static_cast<std::size_t>(dimension) + static_cast<std::size_t>(k)] *
            moved_[i];
    }
  place_ = {x[0], x[1], x[2], X[0], X[1], X[2], place_.t};
  if (dimension != dofs_.mesh().dimension) return;
  for (int k = dimension; k < 3; ++k)
    jacobian_(k, k) = 1;
  inverse_ = adjugate(jacobian_);
  const double volume = determinant(jacobian_);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      inverse_(k, j) /= volume;
}

double FieldSampler::stretch() const {
  return stretch_at(static_cast<int>(point_), points_, geometry_, moved_.data());
}

Vector<double, 3> FieldSampler::moved(const double* dxi) const {
  Vector<double, 3> result;
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < traits(region_.shape).dimension; ++k)
      result[j] += jacobian_(j, k) * dxi[k];
  return result;
}

double FieldSampler::value(std::size_t k, int component) const {
  const Field& field = fields_[k];
  const auto nodes = static_cast<std::size_t>(field.shapes.nodes);
  double sum = 0;
  for (std::size_t a = 0; a < nodes; ++a)
    sum += field.shapes.values[point_ * nodes + a] *
           field.values[a * field.components + static_cast<std::size_t>(component)];
  return sum;
}

double FieldSampler::derivative(std::size_t k, int component, int along) const {
  const Field& field = fields_[k];
  const auto nodes = static_cast<std::size_t>(field.shapes.nodes);
  const int dimension = traits(region_.shape).dimension;
  const auto width = static_cast<std::size_t>(dimension);
  double sum = 0;
  for (std::size_t a = 0; a < nodes; ++a) {
    double slope = 0;
    for (int i = 0; i < dimension; ++i)
      slope += field.shapes.gradients[(point_ * nodes + a) * width + static_cast<std::size_t>(i)] *
               inverse_(i, along);
    sum += slope * field.values[a * field.components + static_cast<std::size_t>(component)];
  }
  return sum;
}

bool lives_throughout(const DofMap& dofs, int field, const Region& region) {
  const Communicator& communicator = dofs.mesh().communicator;
  std::vector<LocalIndex> rows;
  for (LocalIndex cell = 0; cell < region.size(); ++cell)
    if (region.cell_owners[static_cast<std::size_t>(cell)] == communicator.rank())
      dofs.append_cell_rows(field, region, cell, rows);
  return !communicator.any(std::find(rows.begin(), rows.end(), -1) != rows.end());
}

}  // namespace hawser
