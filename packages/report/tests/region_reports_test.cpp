// <integral>, <extreme> and <flux>: what they make of a known state.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "hawser/base/error.hpp"
#include "report_sample.hpp"

namespace hawser {
namespace {

/// Moved by d = (0.25 X, 0), with the velocity (x + 2 y, 3): water of 5 by 2.
void move(ReportSample& sample) {
  sample.set("displacement", [](const double* X, int c) { return c == 0 ? 0.25 * X[0] : 0; });
  sample.set("velocity",
             [](const double* X, int c) { return c == 0 ? 1.25 * X[0] + 2 * X[1] : 3; });
}

class RegionReports : public testing::Test {
 protected:
  RegionReports() {
    register_reports(registry_);
    move(sample_);
  }
  static std::vector<double> measured(const ReportSample& sample, const ReportRegistry& registry,
                                      const std::string& text) {
    Diagnostics faults;
    Reports reports = sample.reports(registry, text, faults);
    EXPECT_EQ(faults.error_text(), "");
    reports.accepted(sample.step());
    return reports.all().back()->values();
  }
  std::vector<double> values(const std::string& text) { return measured(sample_, registry_, text); }
  std::vector<std::string> names(const std::string& text) {
    Diagnostics faults;
    return sample_.reports(registry_, text, faults).all().back()->quantities();
  }
  std::string faults(const std::string& text) {
    Diagnostics faults;
    sample_.reports(registry_, text, faults);
    return faults.error_text();
  }

  ReportSample sample_;
  ReportRegistry registry_;
};

TEST_F(RegionReports, AnIntegralIsThatOfTheMovedRegion) {
  EXPECT_NEAR(values("<integral name='a' of='1' on='water'/>")[0], 10, 1e-13);
  EXPECT_NEAR(values("<integral name='a' of='velocity_x' on='water'/>")[0], 10 * (2.5 + 2), 1e-12);
  EXPECT_NEAR(values("<integral name='a' of='velocity_x' on='water' mean='true'/>")[0], 4.5, 1e-13);
  EXPECT_NEAR(values("<integral name='a' of='dx(velocity_x) + t' on='water'/>")[0], 10, 1e-12);
  EXPECT_NEAR(values("<integral name='a' of='velocity_y*normal_y' on='wall'/>")[0], 0, 1e-12);
  EXPECT_NEAR(values("<integral name='a' of='x*normal_x' on='wall'/>")[0], 10, 1e-12);
  EXPECT_NEAR(values("<integral name='a' of='velocity_x^2' on='cable'/>")[0], (343 - 8) / 3.0,
              1e-12);  // of (x + 2)^2 on [0, 5]
  EXPECT_EQ(names("<integral name='heat' of='1' on='water' unit='W/m'/>"),
            std::vector<std::string>{"heat_w_per_m"});
}

TEST_F(RegionReports, IntegralsAreTheSameToTheLastBitOnAnyNumberOfRanks) {
  const std::string text = "<integral name='a' of='sin(velocity_x) + exp(x*y)' on='water'/>";
  const std::vector<double> together = values(text);
  if (!Communicator().is_root()) return;  // the mesh of the test is one file
  ReportSample alone(Communicator(MPI_COMM_SELF));
  move(alone);
  EXPECT_EQ(together, measured(alone, registry_, text));
}

TEST_F(RegionReports, AnExtremeHasItsPlace) {
  EXPECT_EQ(values("<extreme name='a' of='velocity_x' on='water'/>"),
            (std::vector<double>{0, 0, 0, 9, 5, 2}));
  EXPECT_EQ(values("<extreme name='a' of='velocity_x' on='cable'/>"),
            (std::vector<double>{2, 0, 1, 7, 5, 1}));
  // The top of a parabola is on the lattice here: x = 2.5 in the second cell of four.
  const auto parabola = values("<extreme name='a' of='x*(5 - x)' on='cable'/>");
  EXPECT_NEAR(parabola[3], 6.25, 1e-14);
  EXPECT_NEAR(parabola[4], 2.5, 1e-14);
  EXPECT_EQ(names("<extreme name='v' of='velocity_x' on='water'/>"),
            (std::vector<std::string>{"v_min_m_per_s", "v_min_x_m", "v_min_y_m", "v_max_m_per_s",
                                      "v_max_x_m", "v_max_y_m"}));
  EXPECT_EQ(names("<extreme name='v' of='dx(displacement_x)' on='water'/>")[0], "v_min");
  EXPECT_EQ(names("<extreme name='v' of='2*velocity_x' on='water' unit='kn'/>")[0], "v_min_kn");
}

TEST_F(RegionReports, AFluxIsTheReactionOrTheLoadOfAModule) {
  sample_.reactions.assign(sample_.reactions.size(), 2);
  EXPECT_EQ(values("<flux name='a' field='velocity' on='cable'/>"), (std::vector<double>{10, 10}));
  EXPECT_DOUBLE_EQ(values("<flux name='a' field='velocity' on='tail' module='cable'/>")[0], -110);
  EXPECT_EQ(names("<flux name='a' field='velocity' on='cable'/>"),
            (std::vector<std::string>{"a_flux_x_n_per_m", "a_flux_y_n_per_m"}));
}

TEST_F(RegionReports, APointIsInTheCellThatHasMovedThere) {
  const auto at = values("<point name='p' at='2.3 0.7' of='velocity_x; dx(velocity_x); X; 2*t'/>");
  EXPECT_NEAR(at[0], 2.3 + 1.4, 1e-13);
  EXPECT_NEAR(at[1], 1, 1e-13);
  EXPECT_NEAR(at[2], 2.3 / 1.25, 1e-13);
  EXPECT_EQ(at[3], 0);
  EXPECT_EQ(
      names("<point name='p' at='2.3 0.7' of='velocity_x; dx(velocity_x); X; 2*t'/>"),
      (std::vector<std::string>{"p_velocity_x_m_per_s", "p_dx_velocity_x_1_per_s", "p_3", "p_4"}));
  EXPECT_EQ(names("<point name='p' at='2.3 0.7' of='2*velocity_x' unit='m/s'/>"),
            (std::vector<std::string>{"p_m_per_s"}));
  EXPECT_NEAR(values("<point name='p' at='5 2' of='velocity_x'/>")[0], 9, 1e-13);
}

TEST_F(RegionReports, ALineIsATableOfWhatIsInTheBody) {
  const std::string text =
      "<line name='middle' from='-1 1' to='5 1' points='7' of='velocity_x; y^2' unit='m^2'/>";
  const auto extremes = values(text);
  EXPECT_EQ(extremes[1], 1);
  EXPECT_NEAR(extremes[0], 2, 1e-13);
  EXPECT_NEAR(extremes[2], 7, 1e-13);
  EXPECT_EQ(extremes[3], 6);
  EXPECT_EQ(names(text)[3], "middle_velocity_x_max_along_m");
  Diagnostics faults;
  Reports reports = sample_.reports(registry_, text, faults);
  reports.start({".", sample_.state, false});
  reports.accepted(sample_.step());
  reports.write(sample_.step(), true, false);
  reports.write(sample_.step(), true, true);
  std::ifstream file("line_middle.csv");
  std::string header, first, line;
  std::getline(file, header);
  std::getline(file, first);
  int rows = 1;
  while (std::getline(file, line))
    ++rows;
  EXPECT_EQ(header, "t_s,along_m,x_m,y_m,velocity_x_m_per_s,value2_m2");
  EXPECT_EQ(first, "0,1,0,1,2,1");
  EXPECT_EQ(rows, 6);
}

TEST_F(RegionReports, WhatDoesNotFitIsSaid) {
  EXPECT_NE(faults("<point name='p' at='1 2 3' of='1'/>").find("has 3 coordinates, the mesh 2"),
            std::string::npos);
  EXPECT_NE(faults("<line name='p' from='1 2' to='1 2' of='1'/>").find("ends where it begins"),
            std::string::npos);
  EXPECT_EQ(faults("<integral name='a' of='velocity_u' on='water'/>").find("d.xml:1:28: "), 0U);
  EXPECT_NE(faults("<integral name='a' of='1' on='watr'/>").find("did you mean 'water'?"),
            std::string::npos);
  EXPECT_NE(faults("<integral name='a' of='1' on='tail'/>").find("a <probe> gives the value there"),
            std::string::npos);
  EXPECT_NE(faults("<extreme name='a' of='1' on='tail'/>").find("has no extremes"),
            std::string::npos);
  EXPECT_NE(faults("<integral name='a' of='1' on='water' unit='Wat'/>").find("the unit 'Wat'"),
            std::string::npos);
  EXPECT_NE(faults("<flux name='a' field='velocty' on='water'/>").find("did you mean 'velocity'?"),
            std::string::npos);
}

TEST_F(RegionReports, AFormulaWithoutAValueEndsTheStepOnAllRanks) {
  Diagnostics faults;
  Reports reports =
      sample_.reports(registry_, "<integral name='a' of='1/(velocity_y - 3)' on='water'/>", faults);
  EXPECT_THROW(reports.accepted(sample_.step()), SolveError);
}

TEST(StatisticsReport, LooksAtAColumnOfAnotherAndGoesOnAfterARestart) {
  ReportRegistry registry;
  register_reports(registry);
  ReportSample sample;
  const std::string deck =
      "<integral name='mean' of='velocity_x' on='water' mean='true' unit='m/s'/>"
      "<statistics name='s' of='mean_m_per_s' from='1' periods='2'/>";
  const auto run = [&](Reports& reports, int from, int to) {
    for (int i = from; i < to; ++i) {
      sample.state.time = 0.05 * i;
      const double speed = 5 + std::sin(2 * M_PI * sample.state.time);
      sample.set("velocity", [&](const double* /*X*/, int c) { return c == 0 ? speed : 0; });
      reports.accepted(sample.step(i));
    }
  };
  Diagnostics faults;
  Reports whole = sample.reports(registry, deck, faults);
  EXPECT_EQ(faults.error_text(), "");
  run(whole, 1, 90);
  Reports first = sample.reports(registry, deck, faults);
  run(first, 1, 50);
  CheckpointHeader header;
  first.save(header);
  Reports second = sample.reports(registry, deck, faults);
  second.resume(header);
  run(second, 50, 90);
  Summary at_once, in_parts;
  whole.summarise(sample.step(89), at_once);
  second.summarise(sample.step(89), in_parts);
  for (const char* const name : {"s_average_m_per_s", "s_middle_m_per_s", "s_amplitude_m_per_s",
                                 "s_frequency_hz", "s_periods", "s_amplitude_scatter"})
    EXPECT_EQ(at_once.number(name), in_parts.number(name)) << name;
  EXPECT_EQ(at_once.number("s_periods"), 2);
  EXPECT_NEAR(at_once.number("s_amplitude_m_per_s").value(), 1, 1e-3);
  EXPECT_NEAR(at_once.number("s_frequency_hz").value(), 1, 1e-6);
}

TEST(StatisticsReport, RefusesAColumnThatNobodyGives) {
  ReportRegistry registry;
  register_reports(registry);
  const ReportSample sample;
  Diagnostics faults;
  sample.reports(registry, "<statistics name='s' of='courant_mx'/>", faults);
  EXPECT_NE(faults.error_text().find(
                "no report here gives a column 'courant_mx' of history.csv; there are "),
            std::string::npos);
  EXPECT_NE(faults.error_text().find("did you mean 'courant_max'?"), std::string::npos);
}

}  // namespace
}  // namespace hawser
