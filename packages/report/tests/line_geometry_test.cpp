#include "hawser/report/line_geometry.hpp"

#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "report_sample.hpp"

namespace hawser {
namespace {

TEST(LineGeometry, BeginsAtTheGivenEnd) {
  ReportSample sample;
  sample.set("displacement", [](const double* x, int j) { return j == 0 ? x[0] : -0.5; });
  for (const auto& [start, from, way] : {std::tuple{"tow-point", 0, 1}, {"tail", 4, -1}}) {
    const LineGeometry line(*sample.dofs, sample.mesh.region("cable"), sample.mesh.region(start));
    ASSERT_EQ(line.size(), 5U);
    EXPECT_EQ(line.arc_length(), (std::vector<double>{0, 1, 2, 3, 4}));
    const std::vector<double> x = line.positions(sample.state);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(x[2 * i], 2 * (from + way * static_cast<int>(i)));
      EXPECT_EQ(x[2 * i + 1], 0.5);
    }
  }
}

TEST(LineGeometry, GathersCellsInOrder) {
  const ReportSample sample;
  const Region& cable = sample.mesh.region("cable");
  const LineGeometry line(*sample.dofs, cable, sample.mesh.region("tail"));
  std::vector<double> values;  // twice the place of a cell's middle
  for (std::size_t cell = 0; cell < cable.cell_ids.size(); ++cell) {
    const auto x = [&](std::size_t k) {
      return sample.mesh.coordinates[2 * static_cast<std::size_t>(cable.vertices[2 * cell + k])];
    };
    values.push_back(x(0) + x(1));
  }
  EXPECT_EQ(line.gather_cells(values), (std::vector<double>{7, 5, 3, 1}));
}

TEST(LineGeometry, RefusesARingAndAStartInTheMiddle) {
  MeshText text = grid(2, 2);
  text.groups.push_back({"middle", 0, {{4}}});
  text.groups.push_back({"corner", 0, {{0}}});
  text.groups.push_back(line("cable", {3, 4, 5}));
  const Mesh mesh = read_text(Communicator(), text.in_format("4.1"));
  const DofMap dofs(mesh,
                    {{"velocity", "m/s", "N/m", 2, Basis::p1, Numbering::continuous, {"water"}}});
  EXPECT_THROW(LineGeometry(dofs, mesh.region("wall"), mesh.region("corner")), MeshError);
  EXPECT_THROW(LineGeometry(dofs, mesh.region("cable"), mesh.region("middle")), MeshError);
}

}  // namespace
}  // namespace hawser
