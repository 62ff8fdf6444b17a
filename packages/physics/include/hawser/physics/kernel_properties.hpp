#pragma once
// The properties of one kernel: constants, sources, and their values on one cell.
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/physics/property.hpp"

namespace hawser {

/// [component], in the property's unit; nothing where the module gives no constant.
using PropertyConstant = std::optional<std::vector<double>>;

class KernelProperties {
 public:
  struct Connection {
    std::size_t property = 0;
    Domain on;
    bool adds = true;
    std::unique_ptr<PropertySource> source;
    std::vector<int> fields;   ///< of the source: index among the kernel's
    std::vector<int> columns;  ///< of the source's unknowns: the kernel's; once bound
  };

  /// One constant per property, or none at all.
  KernelProperties(std::vector<PropertyUse> uses, std::vector<PropertyConstant> constants);

  const std::vector<PropertyUse>& uses() const { return uses_; }
  /// For the properties of a field that a deck names.
  void rename(std::size_t property, const std::string& name) {
    names_.push_back(name);
    uses_[property].name = names_.back().c_str();
  }
  /// The module gives a constant.
  bool has_constant(std::size_t property) const { return constants_[property].has_value(); }
  const std::vector<Connection>& connections() const { return connections_; }
  bool supplied() const { return !connections_.empty(); }

  /// Adds to `fields` what the source reads and the kernel does not.
  void connect(std::size_t property, const Supply& supply, std::vector<FieldUse>& fields);
  /// With the shapes of all of the kernel's fields at the points where it wants its properties.
  /// Where nothing is supplied, one point has the constants.
  void bind(const CellTabulation& table, const std::vector<FieldUse>& fields);

  int components() const { return components_; }  ///< of all properties
  /// Values at all points, and slopes where they are asked for. False where det F <= 0. One cell at
  /// a time: the results are kept here.
  bool evaluate(const CellInput& cell, bool with_slopes) const;
  /// [component of all properties], of the last evaluation.
  const double* values(int point) const {
    return supplied() ? &values_[static_cast<std::size_t>(point * components_)] : values_.data();
  }
  /// [component of all properties][unknown of the kernel].
  const double* slopes(int point) const {
    return &slopes_[static_cast<std::size_t>(point * components_ * unknowns_)];
  }
  int unknowns() const { return unknowns_; }

 private:
  std::vector<PropertyUse> uses_;
  std::list<std::string> names_;  // of those that a deck names
  std::vector<PropertyConstant> constants_;
  std::vector<int> first_;  // component of each property
  int components_ = 0;
  std::vector<Connection> connections_;
  int points_ = 1, unknowns_ = 0;
  // [component]: the constants, zero for others; and the values where nobody gives any.
  std::vector<double> start_, otherwise_;
  // Of the cell evaluated last; those of one source before they are added.
  mutable std::vector<double> values_, slopes_, part_, part_slopes_;
  mutable std::vector<FieldOnCell> part_fields_;
  mutable std::vector<char> given_;  // [property]
};

}  // namespace hawser
