#include "hawser/conditions/sources.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "sample_conditions.hpp"

namespace hawser {
namespace {

using testing::HasSubstr;

/// A <prescribe> with these attributes beside its field.
ConditionDeck condition(const std::string& attributes, Diagnostics& diagnostics) {
  const ConditionsDeck deck =
      conditions_of(R"(<prescribe field="velocity" on="cable" )" + attributes + "/>", diagnostics);
  return deck.prescribe.at(0);
}

const WantedValues velocity{"velocity", "m/s", {"x", "y"}, 0, 2, false};

TEST(Sources, ExactlyOneIsGiven) {
  for (const char* attributes :
       {"", R"(value="0 0" table="a.csv")", R"(table="a.csv" track="b")"}) {
    Diagnostics diagnostics;
    condition(attributes, diagnostics);
    EXPECT_THAT(diagnostics.error_text(),
                HasSubstr("<prescribe> needs exactly one of value, table and track"));
  }
}

TEST(Sources, EachKindMakesItsOwn) {
  std::ofstream("current.csv") << "t_s,u_m_per_s,v_m_per_s\n0,1,2\n10,3,4\n";
  Diagnostics diagnostics;
  TrackDeck line;
  line.name.value = "line";
  line.speed = 2, line.ramp = 10;
  line.way_points = {{{0, 0}}, {{0, 100}}};
  NamedSources named{make_tracks({line}, diagnostics), {}};
  named.tables.resize(1);
  named.tables[0].name.value = "measured";
  named.tables[0].file.value = "current.csv";
  named.tables[0].time_origin = 5;
  const Communicator world;
  const SourceContext context{world, named, velocity, diagnostics};
  SpaceTime at;
  at.t = 5;
  double values[2];
  condition(R"(value="t; 2*t")", diagnostics).make_source(context)->value(at, values);
  EXPECT_THAT(values, testing::ElementsAre(5, 10));
  condition(R"(table="current.csv")", diagnostics).make_source(context)->value(at, values);
  EXPECT_THAT(values, testing::ElementsAre(2, 3));
  condition(R"(table="measured")", diagnostics).make_source(context)->value(at, values);
  EXPECT_THAT(values, testing::ElementsAre(3, 4));
  condition(R"(track="line")", diagnostics).make_source(context)->value(at, values);
  EXPECT_NEAR(values[1], 2 * 10 * (2.5 - 1.5 + 0.25) / 16, 1e-14);  // ramp_distance, s = 1/2
  EXPECT_TRUE(diagnostics.ok()) << diagnostics.error_text();
}

TEST(Sources, AMissingOneIsReportedAtItsAttribute) {
  Diagnostics diagnostics;
  const Communicator world;
  NamedSources named;
  named.tables.resize(1);
  named.tables[0].name.value = "adcp";
  const SourceContext context{world, named, velocity, diagnostics};
  EXPECT_EQ(condition(R"(table="none.csv")", diagnostics).make_source(context), nullptr);
  EXPECT_THAT(diagnostics.error_text(), HasSubstr("d.xml:1:"));
  EXPECT_THAT(diagnostics.error_text(),
              HasSubstr("cannot read the table none.csv, and there is no <table> of that name; "
                        "there are adcp"));
  EXPECT_EQ(condition(R"(track="none")", diagnostics).make_source(context), nullptr);
  EXPECT_THAT(diagnostics.error_text(), HasSubstr("the deck has no track 'none'; it has none"));
}

}  // namespace
}  // namespace hawser
