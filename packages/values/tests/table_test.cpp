#include "hawser/values/table.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "hawser/base/constants.hpp"
#include "hawser/base/error.hpp"
#include "table_reading.hpp"

namespace hawser {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

std::shared_ptr<const Table> table_of(const TableText& given) {
  const TableReading reading = read(given);
  EXPECT_EQ(reading.faults, "");
  return reading.table;
}

TEST(Table, InterpolatesLinearlyInTime) {
  const auto table = table_of(
      {"time_s,velocity_x_m_per_s,velocity_y_m_per_s\n# tide\n0,0,-0.5\n\n100,1,-0.4\n300,0,0\n"});
  EXPECT_THAT(values(*table, at(50)), ElementsAre(0.5, -0.45));
  EXPECT_THAT(values(*table, at(200))[0], 0.5);
  EXPECT_THAT(values(*table, at(300))[1], 0);
  double rates[2];
  table->time_derivative(at(200), rates);
  EXPECT_DOUBLE_EQ(rates[0], -0.005);
  EXPECT_DOUBLE_EQ(rates[1], 0.002);
  EXPECT_FALSE(table->depends_on_moved_position());
  EXPECT_TRUE(table->span().covers(0, 300));
  EXPECT_FALSE(table->span().covers(0, 301));
  EXPECT_FALSE(table->span().covers(-1, 10));
}

// A bilinear function of time and place comes out exactly, with its slopes; rows in any order.
TEST(Table, IsExactForProductsOfLinearFunctions) {
  const auto f = [](double t, double x, double y) { return (1 + 2 * t) * (3 - x) * (2 + 0.5 * y); };
  std::string text = "y_m,t_s,heat_K,x_m\n";
  for (const double x : {4.0, -1.0, 1.5})
    for (const double t : {0.0, 10.0})
      for (const double y : {2.0, -2.0, 0.0})
        text += std::to_string(y) + "," + std::to_string(t) + "," + std::to_string(f(t, x, y)) +
                "," + std::to_string(x) + "\n";
  const auto table = table_of({text, scalar("heat", "K")});
  ASSERT_EQ(table->components(), 1);
  EXPECT_TRUE(table->depends_on_moved_position());
  for (const double t : {0.0, 3.0, 10.0})
    for (const double x : {-1.0, 0.2, 4.0})
      for (const double y : {-2.0, 1.7, 2.0}) {
        double value = 0, rate = 0, slope[3];
        table->value(at(t, x, y), &value);
        EXPECT_NEAR(value, f(t, x, y), 1e-12);
        table->time_derivative(at(t, x, y), &rate);
        EXPECT_NEAR(rate, 2 * (3 - x) * (2 + 0.5 * y), 1e-12);
        table->gradient(at(t, x, y), 0, slope);
        EXPECT_NEAR(slope[0], -(1 + 2 * t) * (2 + 0.5 * y), 1e-11);
        EXPECT_NEAR(slope[1], 0.5 * (1 + 2 * t) * (3 - x), 1e-11);
        EXPECT_EQ(slope[2], 0);
      }
}

TEST(Table, DependsOnDepthWhereItHasAColumnOfIt) {
  const auto table = table_of({"z_m,heat_K\n-100,280\n0,290\n", scalar("heat", "K")});
  EXPECT_THAT(values(*table, at(0, 0, 0, -25)), ElementsAre(287.5));
  double slope[3];
  table->gradient(at(0, 0, 0, -25), 0, slope);
  EXPECT_THAT(slope, ElementsAre(0, 0, DoubleNear(0.1, 1e-15)));
  EXPECT_TRUE(table->span().covers(-1e9, 1e9));
}

// The derivatives are those of the pieces: at a knot of the later one, at the last knot of the
// last.
TEST(Table, DerivativesAtAKnotAreThoseOfTheLaterPiece) {
  const auto table =
      table_of({"t_s,x_m,heat_K\n0,0,1\n10,0,2\n30,0,0\n0,4,1\n10,4,2\n30,4,0\n"
                "0,5,3\n10,5,4\n30,5,2\n",
                scalar("heat", "K")});
  double rate = 0, slope[3];
  for (const auto& [t, expected] : {std::pair(9.99, 0.1), {10.0, -0.1}, {30.0, -0.1}}) {
    table->time_derivative(at(t, 0), &rate);
    EXPECT_DOUBLE_EQ(rate, expected) << t;
  }
  for (const auto& [x, expected] : {std::pair(3.99, 0.0), {4.0, 2.0}, {5.0, 2.0}}) {
    table->gradient(at(0, x), 0, slope);
    EXPECT_NEAR(slope[0], expected, 1e-14) << x;
  }
}

TEST(Table, HasNoValueOutside) {
  const auto table =
      table_of({"t_s,x_m,heat_K\n0,0,1\n10,0,2\n0,5,3\n10,5,4\n", scalar("heat", "K")});
  EXPECT_THAT(values(*table, at(10 * (1 + 1e-12), 5)), ElementsAre(4));
  EXPECT_THROW(values(*table, at(10.1, 0)), DeckError);
  try {
    values(*table, at(3, -1));
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_STREQ(error.what(), "t.csv: no value at x = -1 m; the table reaches from 0 to 5");
  }
}

struct Named {
  std::string header, row;
  double time, x, y;
};
class ColumnNames : public testing::TestWithParam<Named> {};

// Whatever the order and the units, the same: at `time`, velocity (x, y).
TEST_P(ColumnNames, SayQuantityAndUnit) {
  const Named& given = GetParam();
  const auto table =
      table_of({given.header + "\n" + given.row + "\n", velocity(), with_direction("going-to")});
  ASSERT_NE(table, nullptr);
  EXPECT_TRUE(table->span().covers(given.time, given.time));
  EXPECT_THAT(values(*table, at(given.time)),
              ElementsAre(DoubleNear(given.x, 1e-15), DoubleNear(given.y, 1e-15)));
}

constexpr double knot = 1852.0 / 3600;
INSTANTIATE_TEST_SUITE_P(
    Table, ColumnNames,
    testing::Values(Named{"time_s,speed_m_per_s,direction_deg", "60,0.5,90", 60, 0.5, 0},
                    Named{"time_min,speed_kn,direction_deg", "1,1,180", 60, 0, -knot},
                    Named{"time_h,direction_rad,speed_cm_per_s", "0.5,0,25", 1800, 0, 0.25},
                    Named{"t_d,speed_km_per_h,direction_deg", "1,3.6,270", 86400, -1, 0},
                    Named{"speed_m/s,t_s,heading_deg", "2,5,30", 5, 1, std::sqrt(3.0)},
                    Named{"speed [m/s],time [s],course [deg]", "2,5,-30", 5, -1, std::sqrt(3.0)},
                    Named{"speed (kn),time (min),direction (deg)", "2,0,360", 0, 0, 2 * knot},
                    Named{"speed_m_s-1,time_ms,direction_deg", "1,500,0", 0.5, 0, 1}));

class ComponentNames : public testing::TestWithParam<Named> {};
TEST_P(ComponentNames, SayQuantityAndUnit) {
  const Named& given = GetParam();
  const auto table = table_of({given.header + "\n" + given.row + "\n"});
  ASSERT_NE(table, nullptr);
  EXPECT_THAT(values(*table, at(given.time)),
              ElementsAre(DoubleNear(given.x, 1e-15), DoubleNear(given.y, 1e-15)));
}
INSTANTIATE_TEST_SUITE_P(
    Table, ComponentNames,
    testing::Values(
        Named{"time_s,velocity_x_m_per_s,velocity_y_m_per_s", "1,0.25,-0.5", 1, 0.25, -0.5},
        Named{"time_s,velocity_y_m_per_s,velocity_x_m_per_s", "1,-0.5,0.25", 1, 0.25, -0.5},
        Named{"velocity_y_cm_per_s,velocity_x_m_per_s,time_h", "-50,0.25,1", 3600, 0.25, -0.5},
        Named{"t_s,u_m_per_s,v_m_per_s", "1,0.25,-0.5", 1, 0.25, -0.5},
        Named{"t_s,v_kn,u_kn", "1,-1,1", 1, knot, -knot},
        Named{"t_s,velocity_x_m/s,velocity_y_m/s", "1,0.25,-0.5", 1, 0.25, -0.5},
        Named{"t_s,velocity_x [m/s],velocity_y [cm/s]", "1,0.25,-50", 1, 0.25, -0.5},
        Named{"t_s, velocity_x_m_s-1 ,velocity_y_km_per_h\r", "1,0.25,-1.8", 1, 0.25, -0.5},
        Named{"# from the meter\nt_s,u_m_per_s,v_m_per_s", "+1,+.25,-5e-1", 1, 0.25, -0.5},
        Named{"t_ms,u_mm_per_s,v_m_per_min", "1000,250,-30", 1, 0.25, -0.5}));

TEST(Table, GivesTheComponentThatIsAskedFor) {
  const std::string text = "time_s,velocity_x_m_per_s,velocity_y_m_per_s\n0,1,2\n";
  EXPECT_THAT(values(*table_of({text, velocity(0, 1)}), at(0)), ElementsAre(1));
  EXPECT_THAT(values(*table_of({text, velocity(1, 1)}), at(0)), ElementsAre(2));
  const auto vector = table_of({"time_s,speed_m_per_s,direction_deg\n0,1,180\n", velocity(1, 1),
                                with_direction("going-to")});
  EXPECT_THAT(values(*vector, at(0)), ElementsAre(DoubleNear(-1, 1e-15)));
}

TEST(Table, DirectionsComeFromOrGoTo) {
  const std::string text = "t_s,speed_m_per_s,direction_deg\n0,0.5,45\n";
  const double part = 0.5 / std::sqrt(2.0);
  const auto going = table_of({text, velocity(), with_direction("going-to")});
  const auto coming = table_of({text, velocity(), with_direction("coming-from")});
  EXPECT_THAT(values(*going, at(0)), ElementsAre(DoubleNear(part, 1e-15), DoubleNear(part, 1e-15)));
  EXPECT_THAT(values(*coming, at(0)),
              ElementsAre(DoubleNear(-part, 1e-15), DoubleNear(-part, 1e-15)));
}

// From 350 to 10 degrees the way is through north, not through south.
TEST(Table, DirectionsAreInterpolatedAsVectors) {
  const auto table = table_of({"t_s,speed_m_per_s,direction_deg\n0,1,350\n10,1,10\n", velocity(),
                               with_direction("going-to")});
  EXPECT_THAT(values(*table, at(5)),
              ElementsAre(DoubleNear(0, 1e-15), DoubleNear(std::cos(pi / 18), 1e-15)));
}

TEST(Table, ChartPositionsCountFromTheOrigin) {
  const auto table =
      table_of({"easting_m,northing_km,u_m_per_s,v_m_per_s\n500000,6000,0,0\n500100,6000,1,0\n"
                "500000,6000.1,0,1\n500100,6000.1,1,1\n",
                velocity(), with_origin(500050, 6000000)});
  EXPECT_THAT(values(*table, at(0, 0, 0)), ElementsAre(0.5, DoubleNear(0, 1e-12)));
  EXPECT_THAT(values(*table, at(0, 50, 50))[1], DoubleNear(0.5, 1e-9));
}

TEST(Table, PositionsAreAPointsDisplacement) {
  TableText given{"time_s,x_m,y_m\n0,10,20\n100,10,120\n", displacement()};
  SpaceTime point = at(50);
  point.X = 10, point.Y = 20;
  const auto table = table_of(given);
  EXPECT_TRUE(table->places_a_point());
  EXPECT_FALSE(table->depends_on_moved_position());
  EXPECT_THAT(values(*table, point), ElementsAre(0, 50));
  double rates[2];
  table->time_derivative(point, rates);
  EXPECT_THAT(rates, ElementsAre(0, 1));
  given.deck.relative = true;
  const auto relative = table_of(given);
  EXPECT_FALSE(relative->places_a_point());
  EXPECT_THAT(values(*relative, at(50)), ElementsAre(0, 50));
}

TEST(Table, ChartPositionsAreAPointsDisplacement) {
  const std::string text = "northing_m,easting_m,time_s\n6000000,500000,0\n6000120,500000,600\n";
  const auto table = table_of({text, displacement(), with_origin(500000, 6000010)});
  EXPECT_THAT(values(*table, at(0)), ElementsAre(0, -10));
  EXPECT_THAT(values(*table, at(600)), ElementsAre(0, 110));
  // Counted from its own start it needs no origin.
  const auto relative =
      table_of({text, displacement(), with([](TableDeck& deck) { deck.relative = true; })});
  EXPECT_THAT(values(*relative, at(600)), ElementsAre(0, 120));
}

TEST(Table, TimesCountFromTheTimeOrigin) {
  const auto table = table_of({"time_h,u_m_per_s,v_m_per_s\n12,0,0\n13,1,0\n", velocity(),
                               with([](TableDeck& deck) { deck.time_origin = 12.5 * 3600; })});
  EXPECT_TRUE(table->span().covers(-1800, 1800));
  EXPECT_THAT(values(*table, at(0)), ElementsAre(0.5, 0));
}

TEST(Table, WhatIsDeclaredMissingIsBridged) {
  for (const char* mark : {"-999", "-999.0", "-9.99e2", "NaN", ""}) {
    const auto table =
        table_of({std::string("t_s,u_m_per_s,v_m_per_s\n0,0,0\n10,") + mark + ",1\n20,2,2\n",
                  velocity(), with_missing({"-999", "NaN"}, 20)});
    EXPECT_THAT(values(*table, at(10)), ElementsAre(1, 1)) << mark;
  }
}

TEST(Table, EveryNumberIsAValueWhereTheDeckSaysSo) {
  const auto table = table_of(
      {"t_s,u_m_per_s,v_m_per_s\n0,-999,0\n10,340,1\n", velocity(), with_missing({"none"})});
  EXPECT_THAT(values(*table, at(0)), ElementsAre(-999, 0));
}

TEST(Table, IgnoresWhatTheDeckNames) {
  const auto table = table_of({"t_s,quality,u_m_per_s,v_m_per_s\n0,good,1,2\n", velocity(),
                               with([](TableDeck& deck) { deck.ignore = {"quality"}; })});
  EXPECT_THAT(values(*table, at(0)), ElementsAre(1, 2));
}

TEST(Table, ASmoothedTrackIsSmoothAndItsRateIsThatOfItsValues) {
  std::string text = "t_s,displacement_x_m,displacement_y_m\n";
  for (int t = 0; t <= 300; ++t)  // 0.2 m/s with fixes that are off by a metre and back
    text += std::to_string(t) + "," + std::to_string(t % 2 == 0 ? 1 : -1) + "," +
            std::to_string(0.2 * t) + "\n";
  const auto table = table_of({text, displacement(), with_smoothing(60)});
  const double h = 1e-3;
  for (double t = 30; t < 270; t += 7.3) {
    const auto before = values(*table, at(t - h)), after = values(*table, at(t + h));
    double rates[2];
    table->time_derivative(at(t), rates);
    EXPECT_NEAR(rates[0], (after[0] - before[0]) / (2 * h), 1e-8);
    EXPECT_NEAR(values(*table, at(t))[0], 0, 1e-3);
    EXPECT_NEAR(rates[1], 0.2, 1e-6);
  }
}

}  // namespace
}  // namespace hawser
