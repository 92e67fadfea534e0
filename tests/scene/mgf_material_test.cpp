// MGF: colours, materials as the model has them, and lamps.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "server/scene/formats/mgf/color.h"
#include "server/scene/formats/mgf/material.h"
#include "tests/scene/mgf_file.h"

namespace raywalk::test {
namespace {

using glm::dvec3;

void expect_color(dvec3 value, dvec3 expected) {
  EXPECT_NEAR(value.r, expected.r, 1e-6);
  EXPECT_NEAR(value.g, expected.g, 1e-6);
  EXPECT_NEAR(value.b, expected.b, 1e-6);
}

/// The material of the only face.
Material material_of(const std::string& statements) {
  const Scene scene = mgf_scene(kMgfSquare + "m\n" + statements + "f a b c\n");
  EXPECT_EQ(scene.materials.size(), 1u);
  return scene.materials[0];
}

TEST(MgfColor, grey_is_white) {
  expect_color(linear_rgb({}), {1, 1, 1});
  expect_color(linear_rgb(chromaticity(1.0 / 3, 1.0 / 3)), {1, 1, 1});
  const double flat[] = {0.2, 0.2};
  expect_color(linear_rgb(spectrum(300, 900, flat)), {1, 1, 1});
}

TEST(MgfColor, primaries_are_pure) {
  const dvec3 red = linear_rgb(chromaticity(0.64, 0.33)), blue = linear_rgb(chromaticity(0.15, 0.06));
  EXPECT_GT(red.r, 3.0);
  expect_color({red.g, red.b, 0}, {0, 0, 0});
  EXPECT_GT(blue.b, 8.0);
  expect_color({blue.r, blue.g, 0}, {0, 0, 0});
}

TEST(MgfColor, beyond_the_primaries_it_fades) {
  for (const auto& [x, y] : {std::pair{0.0, 0.38}, {0.75, 0.1}, {0.1, 0.85}, {0.7, 0.3}}) {
    const dvec3 rgb = linear_rgb(chromaticity(x, y));
    EXPECT_NEAR(std::min({rgb.r, rgb.g, rgb.b}), 0.0, 1e-9);
    // As bright as before: the luminance of the primaries follows from pure ones of luminance 1.
    const auto share = [](double px, double py, int k) { return 1.0 / linear_rgb(chromaticity(px, py))[k]; };
    EXPECT_NEAR(rgb.r * share(0.64, 0.33, 0) + rgb.g * share(0.3, 0.6, 1) + rgb.b * share(0.15, 0.06, 2), 1.0, 1e-6);
  }
}

TEST(MgfColor, spectra_and_temperatures_have_their_hue) {
  const double red[] = {0, 0, 0, 1, 1}, blue[] = {1, 0.5, 0, 0, 0};
  EXPECT_GT(linear_rgb(spectrum(380, 780, red)).r, 2.0);
  EXPECT_GT(linear_rgb(spectrum(380, 780, blue)).b, 2.0);
  const dvec3 warm = linear_rgb(temperature(2800)), cold = linear_rgb(temperature(12000));
  EXPECT_GT(warm.r, warm.g);
  EXPECT_GT(warm.g, 2 * warm.b);
  EXPECT_LT(cold.r, cold.g);
  EXPECT_LT(cold.g, cold.b);
  // The locus of black bodies: 2856 K is illuminant A at (0.4476, 0.4074).
  const dvec3 a = temperature(2856).xyz;
  EXPECT_NEAR(a.x / (a.x + a.y + a.z), 0.4476, 0.006);
  EXPECT_NEAR(a.y / (a.x + a.y + a.z), 0.4074, 0.006);
}

TEST(MgfColor, mixtures_weigh_luminance) {
  const MgfColor red = chromaticity(0.64, 0.33), green = chromaticity(0.3, 0.6);
  const ColorShare shares[] = {{3, red}, {1, green}};
  expect_color(linear_rgb(mixture(shares)), 0.75 * linear_rgb(red) + 0.25 * linear_rgb(green));
}

TEST(MgfMaterial, the_default_is_black) {
  const Material m = material_of("");
  for (const Vec3 color : {m.ambient, m.diffuse, m.specular, m.reflection, m.transmission, m.emission}) {
    EXPECT_EQ(color, (Vec3{0, 0, 0}));
  }
  EXPECT_EQ(m.texture, kNoTexture);
  EXPECT_EQ(m.ior, 1.0f);
}

TEST(MgfMaterial, each_term_takes_the_colour_at_hand) {
  const Material m = material_of(
      "c red =\ncxy 0.64 0.33\nc blue =\ncxy 0.15 0.06\nc mixed =\ncmix 1 red 1 blue\nc red\nrd 0.1\nc blue\nts 0.02 "
      "0\n"
      "c\nrs 0.09 0.1\n");
  EXPECT_GT(m.diffuse.x, 0.3f);
  EXPECT_NEAR(m.diffuse.y, 0.0f, 1e-6f);
  EXPECT_EQ(m.ambient, m.diffuse);
  EXPECT_GT(m.transmission.z, 0.1f);
  EXPECT_NEAR(m.transmission.x, 0.0f, 1e-6f);
  EXPECT_NEAR(m.specular.x, 0.3f, 1e-6f);
  EXPECT_NEAR(m.specular.z, 0.3f, 1e-6f);
  EXPECT_NEAR(m.shininess, 200.0f, 1e-3f);
}

TEST(MgfMaterial, smooth_ones_mirror_and_rough_ones_do_not) {
  const Material smooth = material_of("rs 0.5 0\n"), middle = material_of("rs 0.5 0.1\n"),
                 rough = material_of("rs 0.5 0.3\n"), faint = material_of("rs 0.01 0\n");
  EXPECT_FLOAT_EQ(smooth.reflection.x, 0.5f);
  EXPECT_FLOAT_EQ(smooth.shininess, 1000.0f);
  EXPECT_FLOAT_EQ(middle.reflection.x, 0.125f);
  EXPECT_EQ(rough.reflection, (Vec3{0, 0, 0}));
  EXPECT_EQ(faint.reflection, (Vec3{0, 0, 0}));
  EXPECT_GT(rough.specular.x, 0.0f);
}

TEST(MgfMaterial, only_solids_refract) {
  EXPECT_FLOAT_EQ(material_of("ir 1.5 0\nts 0.9 0\n").ior, 1.0f);
  EXPECT_FLOAT_EQ(material_of("ir 1.5 0\nts 0.9 0\nsides 1\n").ior, 1.5f);
  const Material curtain = material_of("td 0.3\nts 0.9 0\n");
  EXPECT_EQ(curtain.transmission, (Vec3{1, 1, 1}));
}

TEST(MgfMaterial, colours_stay_in_range) {
  const Material m = material_of("c\ncxy 0.15 0.06\nrd 0.9\ned 1e9\n");
  EXPECT_LE(largest(m.diffuse), 1.0f);
  EXPECT_FLOAT_EQ(m.diffuse.z, 1.0f);
  EXPECT_FLOAT_EQ(largest(m.emission), 1.0f);
  EXPECT_EQ(material_of("ed 0\n").emission, (Vec3{0, 0, 0}));
}

TEST(MgfLights, each_lamp_is_one_light_before_or_beside_it) {
  const Scene scene = load_mesh(mgf_sample("lamps.mgf"));
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.lights.size(), 3u);
  const float margin = 0.01f * std::sqrt(2.0f);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(scene.lights[i].position.x, i == 0 ? -1.0f : 1.0f, 1e-5f);
    EXPECT_NEAR(scene.lights[i].position.y, 0.0f, 1e-5f);
    EXPECT_NEAR(scene.lights[i].position.z, 2.99f - margin, 1e-5f);
    EXPECT_FLOAT_EQ(scene.lights[i].intensity.x, scene.lights[i].intensity.z);
  }
  // Outside of the bulb, but next to it, where there is most room.
  const Vec3 away = scene.lights[2].position - Vec3{1.5f, 1.5f, 2.5f};
  EXPECT_GT(length(away), 0.05f);
  EXPECT_LT(length(away), 0.053f);
  EXPECT_LT(smaller(away.x, away.y), -0.04f);
  // Their luminances, of which the grey panels have equal ones, add up to 1.
  const dvec3 warm = linear_rgb(temperature(3000)) * (1.0 - 2.0 * scene.lights[0].intensity.x);
  const Vec3 bulb = scene.lights[2].intensity;
  expect_color({bulb.x, bulb.y, bulb.z}, warm);
  EXPECT_GT(scene.ambient.x, 0.0f);
}

TEST(MgfLights, a_thin_open_box_shines_from_its_wide_side) {
  // Two faces back to back, a hand below the ceiling, without anything between their edges.
  const Scene scene = mgf_scene(kMgfSquare +
                                "m\ned 100\no lamp\nxf -t 0 0 2.700\nf a d c b\nxf\nxf -t 0 0 2.701\nf a b c d\nxf\no\n"
                                "m\nrd 0.5\nxf -t -0.5 -0.5 0 -s 5\nprism a b c d -0.6\nxf\n");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NEAR(scene.lights[0].position.x, 0.5f, 1e-5f);
  EXPECT_NEAR(scene.lights[0].position.y, 0.5f, 1e-5f);
  EXPECT_LT(scene.lights[0].position.z, 2.7f);
  EXPECT_GT(scene.lights[0].position.z, 2.65f);
}

TEST(MgfLights, arrays_of_lamps_share_a_few) {
  const Scene scene = mgf_scene(
      kMgfSquare + "m\ned 100\no lamps\nxf -a 40 -t 3 0 0\nf a b c d\nxf\no\nm\nrd 0.5\nxf -s 200\nf a d c b\nxf\n");
  EXPECT_EQ(scene.lights.size(), 16u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("40 emitters"), std::string::npos);
  float sum = 0.0f;
  for (const Light& light : scene.lights) {
    sum += light.intensity.x;
    EXPECT_GT(light.position.x, 0.0f);
    EXPECT_LT(light.position.x, 118.0f);
  }
  EXPECT_NEAR(sum, 1.0f, 1e-5f);
  // Many more, and the work stays small.
  EXPECT_EQ(mgf_scene(kMgfSquare + "m\ned 100\nxf -a 2000 -t 3 0 0\nf a b c d\nxf\n").lights.size(), 16u);
}

TEST(MgfLights, many_lamps_and_lamps_of_many_surfaces_take_little_time) {
  const std::string lamp = kMgfSquare + "m lamp =\ned 100\n";
  const Scene one = mgf_scene(lamp + "xf -a 50000 -t 1 0 0\nf a b c\nxf\n");
  EXPECT_EQ(one.triangles.size(), 50'000u);
  EXPECT_EQ(one.lights.size(), 1u);
  EXPECT_EQ(mgf_scene(lamp + "xf -a 20000 -t 7 0 0\nf a b c\nxf\n").lights.size(), 16u);
}

TEST(MgfLights, without_lamps_there_is_still_light) {
  EXPECT_EQ(mgf_scene(kMgfSquare + "m\nrd 0.5\nf a b c\n").lights.size(), 1u);
  EXPECT_EQ(mgf_scene(kMgfSquare + "m\ned 100\nf a a a\n").lights.size(), 1u) << "a lamp without area";
}

}  // namespace
}  // namespace raywalk::test
