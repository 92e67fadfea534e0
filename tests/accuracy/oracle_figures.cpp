// Counting judgements: classes, verdicts, percentiles, limits of rates.
#include <gtest/gtest.h>

#include <limits>

#include "server/accuracy/oracle/figures.h"
#include "server/accuracy/rate.h"

namespace raywalk::oracle {
namespace {

TEST(UlpHistogram, PercentilesAreWithinABin) {
  UlpHistogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.add(i / 10.0);
  EXPECT_EQ(histogram.count(), 1000u);
  EXPECT_GE(histogram.percentile(0.5), 50.0);
  EXPECT_LE(histogram.percentile(0.5), 50.0 * 1.07);
  EXPECT_GE(histogram.percentile(0.999), 99.9);
  EXPECT_LE(histogram.percentile(0.999), 100.0);
  EXPECT_EQ(histogram.percentile(1.0), 100.0);
  EXPECT_EQ(histogram.largest(), 100.0);
}

TEST(UlpHistogram, ExtremesAndNothing) {
  UlpHistogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0.0);
  histogram.add(0.0);
  histogram.add(0.0);
  EXPECT_EQ(histogram.percentile(1.0), 0.0);
  histogram.add(1e30);
  EXPECT_EQ(histogram.percentile(1.0), 1e30);
  histogram.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(histogram.largest(), std::numeric_limits<double>::infinity());
  EXPECT_LE(histogram.percentile(0.5), 0x1p-9);
  UlpHistogram other;
  other.add(histogram);
  EXPECT_EQ(other.count(), 4u);
  EXPECT_EQ(other.largest(), histogram.largest());
}

TEST(Figures, CountByClassAndVerdict) {
  Figures figures;
  figures.add({Verdict::right, RayClass::strict, 0.5, true});
  figures.add({Verdict::right, RayClass::near, 1e9});
  figures.add({.verdict = Verdict::leak, .ray_class = RayClass::near});
  figures.add({.verdict = Verdict::tie, .ray_class = RayClass::tie});
  Figures sum;
  sum.add(figures);
  sum.add(figures);
  EXPECT_EQ(sum.rays(), 8u);
  EXPECT_EQ(sum.count(Verdict::right), 4u);
  EXPECT_EQ(sum.count(RayClass::near), 4u);
  EXPECT_EQ(sum.wrong(), 2u);
  EXPECT_EQ(sum.t_ulps.count(), 4u);
  EXPECT_EQ(sum.well_conditioned_t_ulps.count(), 2u);
  EXPECT_STREQ(name_of(Verdict::false_hit), "false_hit");
  EXPECT_STREQ(name_of(RayClass::boundary), "boundary");
}

TEST(Rate, UpperLimit) {
  EXPECT_DOUBLE_EQ(upper95_ppm(0, 1'000'000), 3.0);
  EXPECT_NEAR(upper95_ppm(10, 1'000'000), 16.96, 0.05);
  EXPECT_NEAR(upper95_ppm(1, 1'000'000), 4.74, 0.05);
  EXPECT_EQ(upper95_ppm(0, 0), 0.0);
  EXPECT_EQ(upper95_ppm(0, 1), 1e6);
  EXPECT_EQ(upper95_ppm(2, 2), 1e6);
}

}  // namespace
}  // namespace raywalk::oracle
