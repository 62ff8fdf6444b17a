#include "hawser/physics/kernel_properties.hpp"

#include <algorithm>
#include <string_view>

namespace hawser {

KernelProperties::KernelProperties(std::vector<PropertyUse> uses,
                                   std::vector<PropertyConstant> constants)
    : uses_(std::move(uses)), constants_(std::move(constants)) {
  constants_.resize(uses_.size());
  for (std::size_t p = 0; p < uses_.size(); ++p) {
    first_.push_back(components_);
    components_ += uses_[p].components;
    start_.resize(static_cast<std::size_t>(components_), 0.0);
    otherwise_.resize(start_.size(), uses_[p].otherwise.value_or(0.0));
    values_.resize(start_.size(), uses_[p].otherwise.value_or(0.0));
    if (!constants_[p]) continue;
    for (auto* values : {&start_, &values_})
      std::copy_n(constants_[p]->begin(), uses_[p].components, values->end() - uses_[p].components);
  }
}

void KernelProperties::connect(std::size_t property, const Supply& supply,
                               std::vector<FieldUse>& fields) {
  Connection connection;
  connection.property = property;
  connection.on = supply.on;
  connection.adds = supply.adds;
  connection.source = supply.source->clone();
  for (const FieldUse& use : connection.source->fields()) {
    const auto known = std::find_if(fields.begin(), fields.end(), [&](const FieldUse& other) {
      return std::string_view(other.name) == use.name;
    });
    connection.fields.push_back(static_cast<int>(known - fields.begin()));
    if (known == fields.end()) fields.push_back(use);
  }
  connections_.push_back(std::move(connection));
}

void KernelProperties::bind(const CellTabulation& table, const std::vector<FieldUse>& fields) {
  if (!supplied()) return;
  std::vector<int> first{0};
  for (std::size_t f = 0; f < fields.size(); ++f)
    first.push_back(first.back() + table.fields[f].nodes * fields[f].components);
  points_ = table.rule.points;
  unknowns_ = first.back();
  const auto all = static_cast<std::size_t>(points_) * static_cast<std::size_t>(components_);
  values_.assign(all, 0.0);
  slopes_.assign(all * static_cast<std::size_t>(unknowns_), 0.0);
  part_ = values_;
  part_slopes_ = slopes_;
  for (Connection& connection : connections_) {
    CellTabulation part = table;
    part.fields.clear();
    connection.columns.clear();
    for (const int field : connection.fields) {
      const auto f = static_cast<std::size_t>(field);
      part.fields.push_back(table.fields[f]);
      for (int column = first[f]; column < first[f + 1]; ++column)
        connection.columns.push_back(column);
    }
    connection.source->bind(part);
    part_fields_.resize(std::max(part_fields_.size(), connection.fields.size()));
  }
}

bool KernelProperties::evaluate(const CellInput& cell, bool with_slopes) const {
  if (!supplied()) return true;
  for (int q = 0; q < points_; ++q)
    std::copy(start_.begin(), start_.end(), values_.begin() + q * components_);
  given_.assign(uses_.size(), 0);
  if (with_slopes) std::fill(slopes_.begin(), slopes_.end(), 0.0);
  for (std::size_t k = 0; k < connections_.size(); ++k) {
    if (cell.supplied != nullptr && cell.supplied[k] == 0) continue;
    const Connection& connection = connections_[k];
    given_[connection.property] = 1;
    for (std::size_t f = 0; f < connection.fields.size(); ++f)
      part_fields_[f] = cell.fields[connection.fields[f]];
    CellInput part = cell;
    part.fields = part_fields_.data();
    if (!connection.source->evaluate(part, part_.data(),
                                     with_slopes ? part_slopes_.data() : nullptr))
      return false;
    const int components = uses_[connection.property].components;
    const auto columns = static_cast<int>(connection.columns.size());
    for (int q = 0; q < points_; ++q)
      for (int c = 0; c < components; ++c) {
        const int from = q * components + c;
        const int to = q * components_ + first_[connection.property] + c;
        values_[static_cast<std::size_t>(to)] += part_[static_cast<std::size_t>(from)];
        if (!with_slopes) continue;
        const double* const slope = &part_slopes_[static_cast<std::size_t>(from * columns)];
        double* const sum = &slopes_[static_cast<std::size_t>(to * unknowns_)];
        for (int i = 0; i < columns; ++i)
          sum[connection.columns[static_cast<std::size_t>(i)]] += slope[i];
      }
  }
  for (std::size_t p = 0; p < uses_.size(); ++p)
    if (!constants_[p] && given_[p] == 0)
      for (int q = 0; q < points_; ++q)
        std::copy_n(otherwise_.begin() + first_[p], uses_[p].components,
                    values_.begin() + q * components_ + first_[p]);
  return true;
}

}  // namespace hawser
