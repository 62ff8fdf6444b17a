#pragma once
// Formulas of fields at one place, over time.
#include "src/placed_formulas.hpp"

namespace hawser {

struct PointDeck {
  std::string name, unit = "1";
  Located<std::vector<double>> at;
  FieldExpressions of;
  static Spec<PointDeck> spec();
};

class PointReport : public Report {
 public:
  using Parameters = PointDeck;
  PointReport(const PointDeck& deck, const ReportContext& context, Diagnostics& diagnostics);

  std::vector<Column> columns() const override;
  /// An error where the place is outside of the body at the start.
  void look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const override;

 private:
  std::vector<double> measure(const Step& step) override;

  PointDeck deck_;
  PlacedFormulas formulas_;
  PlacedFormulas::Place place_{};
};

/// A place as a deck gives it; an error where it has not the mesh's dimension.
PlacedFormulas::Place read_place(const Located<std::vector<double>>& given, const Mesh& mesh,
                                 const std::string& what, Diagnostics& diagnostics);

}  // namespace hawser
