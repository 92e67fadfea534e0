// Glass and mirrors: coloured shadows, windows, slabs, total reflection, and that no light is made or lost.
#include <gtest/gtest.h>

#include "tests/support/look.h"
#include "tests/support/shaded_scene.h"

namespace raywalk {
namespace {

using test::grey;
using test::look;
using test::Quad;
using test::ShadedScene;

/// A square parallel to the ground, seen from above by its winding, or from below.
Quad sheet(float height, float half = 10, bool downward = false) {
  const Quad up{{-half, height, half}, {half, height, half}, {half, height, -half}, {-half, height, -half}};
  return downward ? Quad{up.d, up.c, up.b, up.a} : up;
}

Material glass(Vec3 transmission, float ior = 1) {
  return {.transmission = transmission, .ior = ior};
}

constexpr Vec3 kEye{4, 0.5f, 0.25f}, kGround{0, 0, 0};

/// White ground under a lamp at height 4; panes are hung between them. The eye at kEye is below the panes.
struct Ground : ShadedScene {
  Ground() {
    materials = {{.diffuse = {0.75f, 0.5f, 1}}};
    add(sheet(0), 0);
    lights = {{{0.5f, 4, 0.25f}, {1, 1, 1}}};
  }
  /// A pane that is turned either way.
  Ground& hang(float height, const Material& material) {
    materials.push_back(material);
    add(sheet(height, 10, materials.size() % 2 == 0), static_cast<u32>(materials.size() - 1));
    return *this;
  }
  Vec3 seen(Mode mode = Mode::whitted, u32 depth = 0) const {
    return look(test::pack_of(*this), kEye, kGround, mode, depth);
  }
};

TEST(ColoredShadow, IsTheProductOfThePanes) {
  const Vec3 bare = Ground().seen();
  ASSERT_GT(bare.x, 0.5f);
  const Vec3 first{0.5f, 0.25f, 1}, second{0.5f, 1, 0};
  EXPECT_EQ(Ground().hang(2, glass(first)).seen(), bare * first);
  EXPECT_EQ(Ground().hang(2, glass(first, 1.7f)).seen(), bare * first) << "light goes straight on, whatever the ior";
  EXPECT_EQ(Ground().hang(2, glass(first)).hang(3, glass(second)).seen(), bare * first * second);
  EXPECT_EQ(Ground().hang(3, glass(second)).hang(2, glass(first)).seen(Mode::whitted, 3), bare * first * second);
  EXPECT_EQ(Ground().hang(5, glass(first)).seen(), bare) << "a pane beyond the lamp";
}

TEST(ColoredShadow, IsOpaqueInModeShadow) {
  const Vec3 black{0, 0, 0};
  EXPECT_EQ(Ground().hang(2, glass(grey(1))).seen(Mode::shadow), black);
  EXPECT_EQ(Ground().seen(Mode::shadow), Ground().seen());
}

TEST(ColoredShadow, EndsAtWhatLetsNothingThrough) {
  const Vec3 black{0, 0, 0};
  const Material opaque{.diffuse = grey(1)};
  EXPECT_EQ(Ground().hang(2, glass(grey(1))).hang(3, opaque).seen(), black);
  EXPECT_EQ(Ground().hang(3, glass(grey(1))).hang(2, opaque).seen(), black);
  const Material mirror{.reflection = grey(1)};
  EXPECT_EQ(Ground().hang(3, glass(grey(1))).hang(2, mirror).seen(), black);
  EXPECT_EQ(Ground().hang(2, glass({1, 0, 0})).hang(3, glass({0, 1, 0})).seen(), black);
}

TEST(ColoredShadow, PassesABoundedNumberOfSurfaces) {
  const Vec3 bare = Ground().seen();
  const auto behind = [](u32 panes) {
    Ground scene;
    for (u32 i = 0; i < panes; ++i) scene.hang(1 + 0.1f * static_cast<float>(i), glass(grey(1)));
    return scene.seen();
  };
  EXPECT_EQ(behind(1), bare);
  EXPECT_EQ(behind(kMaxPanes), bare);
  EXPECT_EQ(behind(kMaxPanes + 1), (Vec3{0, 0, 0}));
}

TEST(ColoredShadow, APaneAtTheLampCountsOnceAtMost) {
  const Vec3 bare = Ground().seen();
  const float half = 0.5f;
  for (float height : {3.9999998f, 4.0f, 4.0000005f}) {
    const Vec3 seen = Ground().hang(height, glass(grey(half))).seen();
    EXPECT_TRUE(seen == bare || seen == bare * half) << height;
  }
}

TEST(ColoredShadow, IsEachLampsOwn) {
  Ground scene;
  scene.lights.push_back({{-0.5f, 2, 0.5f}, {0.5f, 0.5f, 0.5f}});
  const Vec3 both = scene.seen();
  scene.lights.pop_back();
  const Vec3 first = scene.seen();
  scene.lights.push_back({{-0.5f, 2, 0.5f}, {0.5f, 0.5f, 0.5f}});
  scene.hang(3, glass({0.5f, 1, 0}));  // above the second lamp
  EXPECT_LT(test::largest_difference(scene.seen(), both - first * Vec3{0.5f, 0, 1}), 1e-6f);
}

/// Counts what is asked of it.
struct AskedTracer : SingleTracer<Brute, NoCounter> {
  u32 closest_queries = 0, any_queries = 0;
  void closest(const Ray* rays, const bool* active, Hit* hits) {
    closest_queries += active[0];
    SingleTracer::closest(rays, active, hits);
  }
  void occluded(const Ray* rays, const bool* active, bool* out) {
    any_queries += active[0];
    SingleTracer::occluded(rays, active, out);
  }
};

TEST(ColoredShadow, ScenesWithoutGlassKeepAnyHitRays) {
  const auto asked = [](const ShadedScene& scene, Mode mode) {
    const Blob blob = test::pack_of(scene);
    AskedTracer tracer{{SceneView{blob.data()}, nullptr}};
    test::look_with(tracer, blob, test::towards(kEye, kGround, mode));
    return std::pair{tracer.closest_queries, tracer.any_queries};
  };
  const Material opaque{.diffuse = grey(1)};
  EXPECT_EQ(asked(Ground().hang(2, opaque), Mode::whitted), (std::pair{1u, 1u}));
  EXPECT_EQ(asked(Ground().hang(2, glass(grey(1))), Mode::shadow), (std::pair{1u, 1u}));
  EXPECT_EQ(asked(Ground().hang(2, glass(grey(1))), Mode::whitted), (std::pair{3u, 0u})) << "to the pane and beyond";
  EXPECT_EQ(asked(Ground().hang(2, opaque).hang(1, glass(grey(1))), Mode::whitted), (std::pair{3u, 0u}));
}

/// Ground that is lit by itself and shows where it was met: red grows with x from -4 to 4, green towards the viewer.
ShadedScene map() {
  ShadedScene scene;
  scene.images = {{2, 2, {0, 0xffu, 0xff00u, 0xffffu}}};
  scene.materials = {{.ambient = {1, 1, 1}, .texture = 0}};
  scene.ambient = {1, 1, 1};
  scene.background = {0.25f, 0.5f, 0.75f};
  const Quad q = sheet(0, 8);
  scene.add(Quad{q.d, q.c, q.b, q.a}, 0);
  return scene;
}

/// Units off a sheet's surface from which a ray goes on (see kernels/shade/spawn.h), rounding of the position included.
constexpr float off_surface(float half) {
  return 3.5e-6f * 2 * half;
}

TEST(Window, OfNoColourShowsWhatIsBehindUnchanged) {
  test::Random random(3);
  for (bool downward : {false, true}) {
    ShadedScene window = map();
    window.materials.push_back(glass(grey(1)));
    window.add(sheet(1, 12, downward), 1);
    const Blob bare = test::pack_of(map()), behind = test::pack_of(window);
    for (int k = 0; k < 300; ++k) {
      const Vec3 eye = random.in_box({-3, 2, -3}, {3, 4, 3}), target = random.in_box({-10, 0, -10}, {10, 0, 10});
      const Vec3 expected = look(bare, eye, target, Mode::whitted, 1);
      const Vec3 seen = look(behind, eye, target, Mode::whitted, 1);
      if (expected == map().background) {
        ASSERT_EQ(seen, expected);
      } else {
        const float slope = length(Vec3{target.x - eye.x, 0, target.z - eye.z}) / eye.y;
        ASSERT_LT(test::largest_difference(seen, expected), (off_surface(12) * slope + 2e-6f) / 8);
      }
      ASSERT_EQ(look(behind, {eye.x, 0.5f, eye.z}, eye, Mode::whitted, 1), window.background) << "up";
    }
  }
}

/// Glass between two heights, wound outward.
ShadedScene slab(float bottom, float top, const Material& material) {
  ShadedScene scene = map();
  scene.materials.push_back(material);
  scene.add(sheet(bottom, 6, true), 1);
  scene.add(sheet(top, 6), 1);
  return scene;
}

TEST(Slab, ShiftsWhatIsBehindAsSnelliusSays) {
  constexpr float kThick = 1, kIor = 1.5f;
  const Blob blob = test::pack_of(slab(1, 1 + kThick, glass(grey(1), kIor)));
  for (float angle : {0.0f, 0.3f, -0.6f, 0.9f}) {
    const float inside = std::asin(std::sin(angle) / kIor);
    // Down from height 3: one through air, the slab, one through air again.
    const float x = 2 * std::tan(angle) + kThick * std::tan(inside);
    const Vec3 seen =
        look(blob, {0, 3, 0}, Vec3{0, 3, 0} + Vec3{std::sin(angle), -std::cos(angle), 0}, Mode::whitted, 2);
    EXPECT_NEAR(seen.x, (x + 4) / 8, (2 * off_surface(6) * std::tan(std::abs(angle)) + 2e-6f) / 8) << angle;
    EXPECT_NEAR(seen.y, 0.5f, 1e-5f) << angle;
  }
}

TEST(Slab, ReflectsTotallyBeyondTheCriticalAngle) {
  ShadedScene scene;
  scene.background = {0.25f, 0.5f, 0.75f};
  scene.materials = {glass(grey(0.5f), 1.5f), glass(grey(0.5f), 1.5f)};
  scene.materials[1].emission = {3, 2, 1};
  scene.add(sheet(0, 100, true), 0);
  scene.add(sheet(1, 100), 1);
  const Blob blob = test::pack_of(scene);
  const auto down = [&](float angle, u32 depth) {
    const Vec3 eye{0, 0.5f, 0};
    return look(blob, eye, eye + Vec3{std::sin(angle), -std::cos(angle), 0}, Mode::whitted, depth);
  };
  const float critical = std::asin(1 / 1.5f);
  EXPECT_EQ(down(critical - 0.01f, 1), 0.5f * scene.background);
  EXPECT_EQ(down(critical + 0.01f, 1), 0.5f * Vec3({3, 2, 1}));
  EXPECT_EQ(down(critical + 0.01f, 3), 0.625f * Vec3({3, 2, 1})) << "up, down and up again";
}

TEST(Mirror, TwoOfThemAddUpToTheDepth) {
  ShadedScene scene;
  scene.materials = {{.reflection = grey(0.5f), .emission = grey(1)}};
  scene.add(sheet(0), 0);
  scene.add(sheet(1, 10, true), 0);
  const Blob blob = test::pack_of(scene);
  float sum = 0, weight = 1;
  for (u32 depth = 0; depth <= kMaxBounces; ++depth, weight *= 0.5f) {
    sum += weight;
    EXPECT_EQ(look(blob, {0, 0.5f, 0}, {0.1f, 0, 0}, Mode::whitted, depth), grey(sum)) << depth;
  }
  EXPECT_EQ(look(blob, {0, 0.5f, 0}, {0.1f, 0, 0}, Mode::whitted, 99), grey(sum)) << "no deeper";
}

/// A glass ball in white all around it; normals of the true sphere times `side`, or none for 0.
ShadedScene ball(u32 level, float side, const Material& material) {
  ShadedScene scene;
  scene.materials = {material};
  scene.background = {1, 1, 1};
  scene.add(test::icosphere(level), 0);
  if (side != 0)
    for (const Corners& t : scene.mesh)
      for (const Vec3 p : {t.a, t.b, t.c}) scene.normals.push_back(normalized(p) * side);
  return scene;
}

TEST(Glass, NeitherMakesNorLosesLight) {
  const Material mixed{.reflection = grey(0.25f), .transmission = grey(0.75f), .ior = 1.5f};
  for (const auto& [level, side] : {std::pair{1u, 0.0f}, {3u, 1.0f}, {3u, -1.0f}}) {
    const Blob clear = test::pack_of(ball(level, side, glass(grey(1), 1.5f))),
               both = test::pack_of(ball(1, side, mixed));
    test::Random random(5);
    u32 unchanged = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec3 eye = 3.0f * random.direction(), target = 0.97f * random.direction();
      const Vec3 seen = look(clear, eye, target, Mode::whitted, kMaxBounces);
      unchanged += seen == grey(1);
      ASSERT_TRUE(seen == grey(1) || seen == grey(0)) << "lost only where the depth ends";
      if (k < 200) {
        ASSERT_LE(look(both, eye, target, Mode::whitted, 8).x, 1.00001f);
      }
    }
    if (side != 0) {  // flat facets keep some light inside
      EXPECT_GE(unchanged, 2970u) << side;
    }
  }
}

TEST(Glass, NormalsOfEitherOrientationAreTheSame) {
  const Material material{.diffuse = grey(0.3f),
                          .specular = grey(0.5f),
                          .reflection = grey(0.25f),
                          .transmission = {0.5f, 0.75f, 0.25f},
                          .shininess = 30,
                          .ior = 1.5f};
  ShadedScene outward = ball(1, 1, material), inward = ball(1, -1, material);
  for (ShadedScene* scene : {&outward, &inward}) {
    scene->background = {0.25f, 0.5f, 1};
    scene->lights = {{{2, 3, 4}, {1, 1, 1}}};
  }
  const Blob a = test::pack_of(outward), b = test::pack_of(inward);
  test::Random random(6);
  for (int k = 0; k < 500; ++k) {
    const Vec3 eye = 3.0f * random.direction(), target = random.direction();
    ASSERT_EQ(look(a, eye, target, Mode::whitted, 4), look(b, eye, target, Mode::whitted, 4));
  }
}

}  // namespace
}  // namespace raywalk
