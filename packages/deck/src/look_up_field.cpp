#include "hawser/deck/look_up_field.hpp"

#include <algorithm>

namespace hawser {
namespace {

/// The fields, by component where they have several.
std::vector<std::string> listed_names(const FormulaNames& names) {
  std::vector<std::string> result;
  for (const NamedField& field : names.fields)
    for (int c = 0; c < field.components; ++c)
      result.push_back(FieldReference{field.name, c, -1, field.components > 1}.name());
  result.insert(result.end(), names.others.begin(), names.others.end());
  return result;
}

std::optional<std::size_t> find(const FormulaNames& names, const std::string& wanted) {
  const auto found = std::find_if(names.fields.begin(), names.fields.end(),
                                  [&](const NamedField& field) { return field.name == wanted; });
  if (found == names.fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.fields.begin());
}

}  // namespace

std::string begin_of_fault(const FieldExpression& formula, const FieldReference& reference) {
  return "'" + reference.text() + "' in the formula '" + formula.text() + "' is ";
}

void refuse_hidden_fields(const FieldExpression& formula, const std::vector<NamedField>& fields,
                          Diagnostics& diagnostics) {
  for (const std::string& parameter : formula.parameters())
    if (find({fields}, parameter))
      diagnostics.error(formula.location(),
                        "'" + parameter + "' in the formula '" + formula.text() +
                            "' is a field and a parameter of the deck; call the parameter "
                            "otherwise");
}

std::optional<FoundField> look_up_field(const FieldExpression& formula,
                                        const FieldReference& reference, const FormulaNames& names,
                                        Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why) {
    diagnostics.error(formula.location(), begin_of_fault(formula, reference) + why);
    return std::nullopt;
  };
  if (reference.along >= names.dimension)
    return refuse("a derivative along z, and the mesh is one in the plane");
  // A scalar field may be called "dye_x".
  auto field = reference.of_vector ? find(names, reference.name()) : std::nullopt;
  const bool whole = field || !reference.of_vector;
  if (!field) field = find(names, reference.field);
  if (!field) {
    const std::vector<std::string> known = listed_names(names);
    return refuse("no field of this run and no parameter; there are " + listed(known) +
                  did_you_mean(reference.name(), formula.names_beside(known)));
  }
  const NamedField& found = names.fields[*field];
  if (whole && found.components > 1)
    return refuse("a field of " + std::to_string(found.components) + " components; write " +
                  found.name + "_x or " + found.name + "_y" +
                  (found.components > 2 ? " or " + found.name + "_z" : ""));
  if (!whole && found.components == 1)
    return refuse("a component, and '" + found.name + "' has only one; write " + found.name);
  if (!whole && reference.component >= found.components)
    return refuse("the third component of a field of two");
  return FoundField{*field, whole ? 0 : reference.component, reference.along};
}

}  // namespace hawser
