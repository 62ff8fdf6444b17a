// A cable of three nodes made by hand: what <tow> and <receivers> say of it.
#include "tow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "report/tests/report_sample.hpp"
#include "tow_report.hpp"

namespace hawser {
namespace {

TEST(Tow, MeasuresFromTheAxisThroughTheFirstNode) {
  // The axis points along +y; two segments of 5 m.
  const std::vector<double> x = {1, 2, 4, -2, 1, -6};
  const std::vector<double> errors = distances_from_axis(x, {0, 1});
  EXPECT_EQ(errors, (std::vector<double>{0, 3, 0}));
  const TowMeasures tow = measure_tow(x, errors, 2);
  EXPECT_EQ(tow.end_error, 0);
  EXPECT_DOUBLE_EQ(tow.total_error, 1);        // mean over the nodes
  EXPECT_DOUBLE_EQ(tow.total_error_arc, 1.5);  // along the cable
  EXPECT_DOUBLE_EQ(tow.length, 10);
  EXPECT_DOUBLE_EQ(tow.cable_angle, 0);
}

TEST(Tow, InSpaceTheErrorIsTheDistanceFromTheAxis) {
  const std::vector<double> errors = distances_from_axis({0, 0, 0, 3, -7, 4}, {0, 1, 0});
  EXPECT_EQ(errors, (std::vector<double>{0, 5}));
}

std::vector<std::string> lines_of(const std::string& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// The cable from (0, 1) to (4, 1), which moves with `pull` m to the right at every node.
struct Towed : ReportSample {
  Towed() { register_tow(registry); }
  void pull(double time, double distance) {
    state.time = time;
    set("displacement", [&](const double*, int j) { return j == 0 ? distance : 0.0; });
  }
  ReportRegistry registry;
};

constexpr const char* tow = "cable='cable' tow-point='tow-point'";

TEST(Tow, OfACableAcrossTheAxisIsOffByItsWholeLength) {
  Towed sample;
  Diagnostics faults;
  Reports reports = sample.reports(
      sample.registry, std::string("<tow ") + tow + " angle='0' speed='1' current='2'/>", faults);
  ASSERT_EQ(faults.error_text(), "");
  const int velocity = sample.dofs->find("velocity");
  for (LocalIndex v = 0; v < sample.mesh.vertices.owned; ++v) {
    const auto row = sample.dofs->first_row(velocity, PointKind::vertex, v);
    const double* const at = &sample.mesh.coordinates[2 * static_cast<std::size_t>(v)];
    if (at[0] == 0 && at[1] == 1) {  // the tow point
      sample.reactions[static_cast<std::size_t>(row)] = -3;
      sample.reactions[static_cast<std::size_t>(row) + 1] = 4;
    }
  }
  reports.accepted(sample.step());
  // end, mean, along; force, along the axis +y, to the left of it; angle, length.
  EXPECT_EQ(reports.all().back()->values(), (std::vector<double>{4, 2, 2, 5, 4, 3, -90, 4}));
  Summary summary;
  reports.summarise(sample.step(), summary);
  EXPECT_EQ(summary.number("tow_force_across_n_per_m"), 3);
  EXPECT_EQ(summary.number("end_error_exact_m"), 0);  // along the current
  EXPECT_NE(reports.closing().find("tow force, per m of depth"), std::string::npos);
}

TEST(Tow, OfTwoEachHasNamesAndFilesOfItsOwn) {
  Towed sample;
  Diagnostics faults;
  const std::string plain = std::string("<tow ") + tow + "/>";
  const std::string named = "<tow name='back' cable='cable' tow-point='tail'><receivers/></tow>";
  Reports reports = sample.reports(sample.registry, plain + named, faults);
  ASSERT_EQ(faults.error_text(), "");
  EXPECT_EQ(reports.all()[1]->columns()[0].name, "end_error");
  EXPECT_EQ(reports.all()[2]->columns()[0].name, "back_end_error");
  EXPECT_EQ(reports.all()[2]->columns()[3].name, "back_tow_force");
  reports.start({".", sample.state, false});
  reports.accepted(sample.step(1, true));
  reports.write(sample.step(1, true), true, true);
  EXPECT_EQ(lines_of("cable.csv").at(2), "0,1,1,1,1");
  EXPECT_EQ(lines_of("back_cable.csv").at(2), "0,1,3,1,1");
  EXPECT_EQ(lines_of("back_receivers.csv").size(), 2U);  // one at the tow point, at the end

  Diagnostics clash;
  sample.reports(sample.registry, plain + plain, clash);
  EXPECT_NE(clash.error_text().find("'end_error_m', too"), std::string::npos);
}

TEST(Tow, ReceiversAreInterpolatedAlongTheCableAndInTime) {
  Towed sample;
  Diagnostics faults;
  Reports reports = sample.reports(
      sample.registry,
      std::string("<tow ") + tow + "><receivers first='0.5' spacing='2' times='1 4'/></tow>",
      faults);
  ASSERT_EQ(faults.error_text(), "");
  sample.pull(0, 0);
  reports.start({".", sample.state, false});
  for (const auto& [time, distance] : {std::pair{2.0, 4.0}, {6.0, 8.0}}) {
    sample.pull(time, distance);
    reports.accepted(sample.step());
    reports.write(sample.step(), true, false);
  }
  // t, number, arc length, x, y, offset, feather angle, tension; two receivers at 0.5 and 2.5 m.
  // The axis is +y, so a cable toward +x lies to starboard, at a right angle.
  const std::vector<std::string> lines = lines_of("receivers.csv");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[1], "1,1,0.5,2.5,1,0.5,90,0");
  EXPECT_EQ(lines[2], "1,2,2.5,4.5,1,2.5,90,0");
  EXPECT_EQ(lines[3], "4,1,0.5,6.5,1,0.5,90,0");
  EXPECT_EQ(lines[4], "4,2,2.5,8.5,1,2.5,90,0");
}

TEST(Tow, RemembersTheEndErrorsOfTheLastQuarterOverARestart) {
  Towed sample;
  const std::string deck = std::string("<tow ") + tow + "/>";
  Diagnostics faults;
  Reports before = sample.reports(sample.registry, deck, faults);
  for (const auto& [time, stretch] : {std::pair{1.0, 1.0}, {8.0, 0.5}}) {
    sample.state.time = time;
    sample.set("displacement", [&](const double* x, int j) { return j == 0 ? stretch * x[0] : 0; });
    before.accepted(sample.step());
  }
  CheckpointHeader header;
  before.save(header);
  Reports after = sample.reports(sample.registry, deck, faults);
  after.resume(header);
  sample.pull(10, 0);
  after.accepted(sample.step());
  Summary summary;
  after.summarise(sample.step(), summary);
  EXPECT_DOUBLE_EQ(summary.number("end_error_change_last_quarter_m").value(), 2);  // 6 m, 4 m
}

}  // namespace
}  // namespace hawser
