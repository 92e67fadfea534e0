// Sensors that fail are told as missing, never as zeros.
#include "server/device/cuda/sensors.h"

#include <gtest/gtest.h>

#include "tests/gpu/fake_driver.h"
#include "tests/support/environment.h"

namespace raywalk::cuda {
namespace {

using test::Variable;
using Reasons = std::vector<std::string>;

class SensorsTest : public testing::Test {
 protected:
  Variable library_{"RAYWALK_LIBNVML", test::fake_driver("fake_nvml")};
};

TEST_F(SensorsTest, TellWhatTheyRead) {
  const Sensors sensors("00000000:01:00.0");
  EXPECT_EQ(sensors.why_not(), "");
  const std::optional<Telemetry> now = sensors.read();
  ASSERT_TRUE(now);
  EXPECT_EQ(now->core_clock_mhz, 1980u);
  EXPECT_EQ(now->memory_clock_mhz, 2619u);
  EXPECT_EQ(now->power_w, 402.5);
  EXPECT_EQ(now->power_limit_w, 700.0);
  EXPECT_EQ(now->temperature_c, 45u);
  EXPECT_EQ(now->throttle_reasons, (Reasons{"power cap", "thermal"}));
}

TEST_F(SensorsTest, OneThatFailsIsNoZero) {
  for (const char* failing : {"power", "temperature"}) {
    const Variable fail("FAKE_NVML_FAIL", failing);
    const Sensors sensors("00000000:01:00.0");
    EXPECT_FALSE(sensors.read()) << failing;
    EXPECT_EQ(sensors.why_not(), "Not all sensors of the GPU can be read.") << failing;
  }
}

TEST_F(SensorsTest, UnknownThrottleReasonsAreNotNone) {
  const Variable fail("FAKE_NVML_FAIL", "throttle");
  const std::optional<Telemetry> now = Sensors("00000000:01:00.0").read();
  ASSERT_TRUE(now);
  EXPECT_EQ(now->throttle_reasons, Reasons{"unknown"});
}

TEST_F(SensorsTest, TellWhyThereAreNone) {
  {
    const Variable fail("FAKE_NVML_FAIL", "device");
    const Sensors sensors("00000000:01:00.0");
    EXPECT_EQ(sensors.why_not(), "NVML does not know the GPU 00000000:01:00.0: Not Supported.");
    EXPECT_FALSE(sensors.read());
  }
  const Variable library("RAYWALK_LIBNVML", "/no/such/libnvidia-ml.so");
  EXPECT_NE(Sensors("00000000:01:00.0").why_not().find("There is no NVML."), std::string::npos);
}

}  // namespace
}  // namespace raywalk::cuda
