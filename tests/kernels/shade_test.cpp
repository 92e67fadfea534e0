// Shading: its small functions against the standard library, features that are absent cost no pixel, spawned rays
// leave.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "kernels/accel/traversals.h"
#include "kernels/frame_cpu.h"
#include "kernels/shade/direct_batch.h"
#include "kernels/tracer.h"
#include "tests/support/meshes.h"
#include "tests/support/rooms.h"

namespace raywalk {
namespace {

constexpr float kSpread = 0.1f;  // of a pixel at distance 1

using BruteTracer = SingleTracer<Brute, NoCounter>;

TEST(Power, AgreesWithTheStandardLibrary) {
  for (float n : {0.0f, 1.0f, 2.0f, 5.5f, 32.0f, 400.0f}) {
    for (float x = 1e-3f; x <= 1.0f; x *= 1.07f) {
      const double exact = std::pow(static_cast<double>(x), static_cast<double>(n));
      if (exact < 1e-35) {
        EXPECT_LE(power(x, n), 1e-34f);
      } else {
        EXPECT_NEAR(power(x, n) / exact, 1.0, 2e-5) << x << "^" << n;
      }
    }
  }
  EXPECT_EQ(power(1.0f, 50.0f), 1.0f);
  EXPECT_EQ(power(0.0f, 8.0f), 0.0f);
}

TEST(Glass, BendsAsSnelliusSays) {
  const Vec3 n{0, 0, 1};
  const float angle = 0.6f;
  const Vec3 d{std::sin(angle), 0, -std::cos(angle)};
  Vec3 out;
  ASSERT_TRUE(refracted(d, n, 1.0f / 1.5f, out));
  EXPECT_NEAR(out.x, std::sin(angle) / 1.5f, 1e-6);
  EXPECT_NEAR(length(out), 1.0f, 1e-6);
  EXPECT_FALSE(refracted({std::sin(1.0f), 0, -std::cos(1.0f)}, n, 1.5f, out)) << "beyond the critical angle";
}

Vec3 pixel(SceneView scene, const FrameArgs& args, u32 x, u32 y, auto radiance_of) {
  BruteTracer tracer{scene, nullptr};
  const bool active = true;
  Vec3 color;
  radiance_of(tracer, args, &x, &y, &active, &color);
  return color;
}

TEST(Features, AbsentOnesChangeNoPixel) {
  const Blob plain = test::room({.mirror = false, .glass = false, .specular = false, .lights = 1, .texture = false});
  ASSERT_EQ(plain.header<SceneHeader>().features, 0u);
  const SceneView scene{plain.data()};
  const FrameArgs args{test::room_camera(24, 16), 24, 16, Mode::whitted, 4, kAllLights};
  for (u32 y = 0; y < args.height; ++y) {
    for (u32 x = 0; x < args.width; ++x) {
      const auto run = [&]<u32 kMask>() {
        return pixel(scene, args, x, y, [&](auto& tracer, const FrameArgs& a, auto... rest) {
          radiance<kMask>(tracer, scene, a, rest...);
        });
      };
      const Vec3 minimal = run.template operator()<0>();
      const Vec3 all = run.template operator()<kAllFeatures>();
      ASSERT_EQ(minimal, all) << x << ", " << y;
    }
  }
}

TEST(Features, EachPresentOneChangesTheImage) {
  const Blob rich = test::room({});
  const SceneView scene{rich.data()};
  const FrameArgs args{test::room_camera(48, 32), 48, 32, Mode::whitted, 4, kAllLights};
  const auto image = [&]<u32 kMask>() {
    std::vector<Vec3> pixels;
    for (u32 y = 0; y < args.height; ++y)
      for (u32 x = 0; x < args.width; ++x)
        pixels.push_back(pixel(scene, args, x, y, [&](auto& tracer, const FrameArgs& a, auto... rest) {
          radiance<kMask>(tracer, scene, a, rest...);
        }));
    return pixels;
  };
  const auto all = image.template operator()<kAllFeatures>();
  EXPECT_FALSE(all == image.template operator()<kAllFeatures & ~kFeatureSpecular>());
  EXPECT_FALSE(all == image.template operator()<kAllFeatures & ~kFeatureRefraction>());
  EXPECT_FALSE(all == image.template operator()<kAllFeatures & ~kFeatureManyLights>());
  EXPECT_FALSE(all == image.template operator()<kAllFeatures & ~kFeatureTextures>());
  EXPECT_FALSE(all == image.template operator()<kAllFeatures & ~(kFeatureReflection | kFeatureRefraction)>());
}

TEST(Whitted, DepthZeroIsShadowModeWithoutGlass) {
  const Blob rich = test::room({.glass = false});
  const SceneView scene{rich.data()};
  FrameArgs whitted{test::room_camera(24, 16), 24, 16, Mode::whitted, 0, kAllLights};
  FrameArgs shadow = whitted;
  shadow.mode = Mode::shadow;
  for (u32 y = 0; y < 16; ++y)
    for (u32 x = 0; x < 24; ++x) {
      const auto run = [&](auto& tracer, const FrameArgs& a, auto... rest) {
        radiance<kAllFeatures>(tracer, scene, a, rest...);
      };
      ASSERT_EQ(pixel(scene, whitted, x, y, run), pixel(scene, shadow, x, y, run));
    }
}

/// Spawns rays from random points of `t`, seen from around it; returns how many left without meeting it again.
int spawn_from(const Corners& t, test::Random& random) {
  const Blob blob = test::make_scene({t});
  const SceneView scene{blob.data()};
  const float scale = length(t.b - t.a) + length(t.c - t.a);
  const auto direction = [&] {
    return normalized(Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  };
  const float a = random.uniform(0, 1), b = random.uniform(0, 1) * (1.0f - a);
  const Vec3 target = t.a + (t.b - t.a) * a + (t.c - t.a) * b;
  const Ray ray = [&] {
    const Vec3 d = direction();
    return Ray{target - d * scale, 0.0f, d, kMaxFloat};
  }();
  BruteTracer tracer{scene, nullptr};
  const bool active = true;
  Hit hit;
  tracer.closest(&ray, &active, &hit);
  if (hit.id == kMiss) return 0;
  const Surface s = surface_at<kAllFeatures>(scene, hit, ray.d, 0.0f);
  int left = 0;
  for (int j = 0; j < 8; ++j) {
    Vec3 d = direction();
    if (j % 2) d = normalized(d - s.geometric_normal * (dot(d, s.geometric_normal) * 0.999f));  // grazing
    const Ray leaving{ErrorBoundOffset::origin(s, d), 0.0f, d, kMaxFloat};
    Hit again;
    tracer.closest(&leaving, &active, &again);
    EXPECT_EQ(again.id, kMiss) << "at distance " << again.t << ", scale " << scale;
    left += again.id == kMiss;
  }
  return left;
}

TEST(Spawn, ARayThatLeavesNeverMeetsItsOwnTriangle) {
  test::Random random(7);
  int left = 0;
  for (int k = 0; k < 20000 && !HasFailure(); ++k) {
    const float scale = std::pow(10.0f, random.uniform(-4, 4));
    const auto point = [&] { return Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
    const Vec3 offset = point() * std::pow(10.0f, random.uniform(-4, 4));
    left += spawn_from(test::triangle(offset + point() * scale, offset + point() * scale, offset + point() * scale),
                       random);
  }
  EXPECT_GT(left, 60000);
}

TEST(Spawn, NorDoesOneThatLeavesACoordinatePlane) {
  test::Random random(8);
  int left = 0;
  for (int k = 0; k < 20000 && !HasFailure(); ++k) {
    const u32 axis = static_cast<u32>(k) % 3;
    const float height = k % 2 ? 0.0f : random.uniform(-10, 10);
    const auto point = [&] {
      const float u = random.uniform(-20, 20), v = random.uniform(-20, 20);
      return axis == 0 ? Vec3{height, u, v} : axis == 1 ? Vec3{u, height, v} : Vec3{u, v, height};
    };
    left += spawn_from(test::triangle(point(), point(), point()), random);
  }
  EXPECT_GT(left, 60000);
}

TEST(Spawn, AShellCloseByIsStillMet) {
  // Two shells 4e-5 apart, also away from the origin: leaving the inner one outward, the outer one is hit.
  for (const Vec3 centre : {Vec3{0, 0, 0}, Vec3{1, -2, 3}}) {
    test::Mesh mesh = test::icosphere(4, 1.0f, centre);
    const u32 inner = static_cast<u32>(mesh.size());
    test::append(mesh, test::icosphere(4, 1.0f + 4e-5f, centre));
    const Blob blob = test::make_scene(mesh);
    const SceneView scene{blob.data()};
    test::Random random(9);
    BruteTracer tracer{scene, nullptr};
    const bool active = true;
    for (int k = 0; k < 300; ++k) {
      const Vec3 d = random.direction();
      const Ray out{centre, 0.0f, d, kMaxFloat};
      Hit hit;
      tracer.closest(&out, &active, &hit);
      ASSERT_LT(hit.id, inner);
      const Surface s = surface_at<kAllFeatures>(scene, hit, d, 0.0f);
      const Ray leaving{ErrorBoundOffset::origin(s, d), 0.0f, d, kMaxFloat};
      tracer.closest(&leaving, &active, &hit);
      ASSERT_TRUE(hit.id != kMiss && hit.id >= inner) << "ray " << k;
      ASSERT_LT(hit.t, 1e-4f);
    }
  }
}

TEST(Surface, BrokenVertexNormalsFallBackToTheTriangle) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, -1};
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vec3 broken : {Vec3{inf, 0, 1}, Vec3{nan, 0, 1}, Vec3{0, 0, 0}, Vec3{0, inf, -inf}}) {
    const Surface s = surface_of(a, b, c, 0.25f, 0.25f, broken, d, 0);
    EXPECT_EQ(s.normal, (Vec3{0, 0, 1}));
  }
}

TEST(Surface, HasAUnitNormalAtAnySize) {
  for (float scale : {1e-18f, 1e-12f, 1e-3f, 1.0f, 1e6f, 1e12f, 1e18f}) {
    const Vec3 a{0, 0, 0}, b{scale, 0, scale}, c{0, 2 * scale, 0}, d{0, 0, -1};
    EXPECT_NEAR(length(surface_of(a, b, c, 0.25f, 0.25f, {0, 0, 0}, d, 0).geometric_normal), 1.0f, 1e-6f) << scale;
  }
}

TEST(Watertight, DistancesScaleWithTheScene) {
  // By a power of two, so that nothing rounds differently: the same hits, t times the scale to the bit.
  const test::Mesh mesh = test::icosphere(2, 2.0f);
  test::Random random(10);
  std::vector<Ray> rays;
  for (int k = 0; k < 300; ++k)
    rays.push_back({random.in_box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), 0.0f, random.direction(), kMaxFloat});
  const auto hits_at = [&](float scale) {
    const Blob blob = test::make_scene(test::transformed(mesh, scale, {0, 0, 0}));
    BruteTracer tracer{SceneView{blob.data()}, nullptr};
    std::vector<Hit> hits(rays.size());
    const bool active = true;
    for (size_t i = 0; i < rays.size(); ++i) {
      Ray ray = rays[i];
      ray.o = ray.o * scale;
      tracer.closest(&ray, &active, &hits[i]);
    }
    return hits;
  };
  const std::vector<Hit> unit = hits_at(1.0f);
  for (int exponent : {-59, -45, -30, 30, 45, 59}) {
    const float scale = std::ldexp(1.0f, exponent);
    const std::vector<Hit> scaled = hits_at(scale);
    for (size_t i = 0; i < rays.size(); ++i) {
      ASSERT_NE(unit[i].id, kMiss);
      ASSERT_EQ(scaled[i].id, unit[i].id) << "2^" << exponent;
      if (std::abs(exponent) <= 45) {
        ASSERT_EQ(scaled[i].t, unit[i].t * scale) << "2^" << exponent;
      } else {  // the edge functions are near the end of the range and lose their last bits
        ASSERT_NEAR(scaled[i].t / scale, unit[i].t, 1e-6f * unit[i].t) << "2^" << exponent;
      }
    }
  }
}

TEST(DirectBatch, IsTheSameAsOneByOne) {
  const Blob rich = test::room({});
  const SceneView scene{rich.data()};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::uniform_int_distribution<u32> triangle(0, scene.triangle_count() - 1);
  for (int k = 0; k < 200; ++k) {
    HitBatch batch;
    const bool one_material = k % 2 == 0;
    const u32 first = triangle(random);
    for (u32 i = 0; i < kBatch; ++i) {
      batch.id[i] = one_material ? first : triangle(random);
      batch.t[i] = unit(random);
      batch.u[i] = unit(random);
      batch.v[i] = unit(random) * (1.0f - batch.u[i]);
      batch.d.set(i, normalized(Vec3{unit(random) - 0.5f, unit(random) - 0.5f, unit(random) - 0.5f}));
    }
    Vec3Batch colors;
    unshadowed_batch(scene, batch, kSpread, scene.light_count(), colors);
    for (u32 i = 0; i < kBatch; ++i) {
      const Hit hit{batch.t[i], batch.id[i], batch.u[i], batch.v[i]};
      ASSERT_EQ(colors.get(i), unshadowed<kAllFeatures>(scene, hit, batch.d.get(i), kSpread, scene.light_count()));
    }
  }
}

}  // namespace
}  // namespace raywalk
