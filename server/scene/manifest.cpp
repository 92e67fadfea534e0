// Reading scene.json: the one place below the API where JSON is known.
#include "server/scene/manifest.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "server/scene/json_node.h"

namespace raywalk {
namespace {

constexpr float kFar = 1e6f;
constexpr u64 kMostTriangles = 1'000'000'000;

GeneratorSource read_generator(const JsonNode& node) {
  node.allow_only({"name", "triangles"});
  return {node.at("name").text(), node.at("triangles").count(1, kMostTriangles)};
}

Material read_material(const JsonNode& node) {
  node.allow_only({"name", "ambient", "diffuse", "specular", "reflection", "transmission", "shininess", "ior"});
  const auto colour = [&](const char* key, Vec3 otherwise) {
    const std::optional<JsonNode> member = node.find(key);
    return member ? member->vector(0.0f, 1.0f) : otherwise;
  };
  node.at("name").text();
  Material m{};
  m.diffuse = node.at("diffuse").vector(0.0f, 1.0f);
  m.ambient = colour("ambient", m.diffuse);
  m.specular = colour("specular", {});
  m.reflection = colour("reflection", {});
  m.transmission = colour("transmission", {});
  const std::optional<JsonNode> shininess = node.find("shininess");
  m.shininess = shininess ? shininess->number(1.0f, 10'000.0f) : 1.0f;
  const std::optional<JsonNode> ior = node.find("ior");
  m.ior = ior ? ior->number(0.1f, 10.0f) : 1.0f;
  return m;
}

Light read_light(const JsonNode& node) {
  node.allow_only({"position", "intensity"});
  return {node.at("position").vector(-kFar, kFar), node.at("intensity").vector(0.0f, 1000.0f)};
}

OrbitPlan read_orbit(const JsonNode& node) {
  node.allow_only({"centre", "radius_factor", "elevation_deg", "start_deg", "turns", "fov_deg"});
  OrbitPlan orbit{};
  if (const std::optional<JsonNode> centre = node.find("centre")) orbit.centre = centre->vector(-kFar, kFar);
  orbit.radius_factor = node.at("radius_factor").number(0.01f, 1000.0f);
  orbit.elevation_deg = node.at("elevation_deg").number(-89.0f, 89.0f);
  orbit.start_deg = node.at("start_deg").number(-360.0f, 360.0f);
  orbit.turns = node.at("turns").number(-100.0f, 100.0f);
  orbit.vertical_fov_deg = node.at("fov_deg").number(1.0f, 170.0f);
  return orbit;
}

SplinePath read_spline(const JsonNode& node, Vec3 up) {
  SplinePath spline{{}, up};
  for (const JsonNode& key : node.items(2)) {
    key.allow_only({"eye", "target", "fov_deg"});
    spline.keys.push_back({key.at("eye").vector(-kFar, kFar), key.at("target").vector(-kFar, kFar),
                           key.at("fov_deg").number(1.0f, 170.0f)});
  }
  return spline;
}

void read_camera(const JsonNode& node, Appearance& appearance) {
  node.allow_only({"frames", "orbit", "spline", "up"});
  appearance.frames = static_cast<u32>(node.at("frames").count(1, 1'000'000));
  const std::optional<JsonNode> orbit = node.find("orbit"), spline = node.find("spline"), up = node.find("up");
  if (orbit.has_value() == spline.has_value()) node.fail("must have one of 'orbit' and 'spline'");
  if (orbit) {
    if (up) up->fail("goes with 'spline' only: an orbit turns around +y");
    appearance.camera = read_orbit(*orbit);
  } else {
    appearance.camera = read_spline(*spline, up ? up->vector(-1.0f, 1.0f) : Vec3{0, 1, 0});
  }
}

void read_lights(const JsonNode& node, std::vector<Light>& lights) {
  lights.clear();
  for (const JsonNode& light : node.items(1)) lights.push_back(read_light(light));
}

Appearance read_appearance(const JsonNode& root) {
  Appearance appearance;
  if (const auto materials = root.find("materials")) {
    for (const JsonNode& m : materials->items(1)) appearance.materials.push_back(read_material(m));
  }
  read_lights(root.at("lights"), appearance.lights);
  appearance.ambient = root.at("ambient").vector(0.0f, 1.0f);
  appearance.background = root.at("background").vector(0.0f, 1.0f);
  read_camera(root.at("camera"), appearance);
  return appearance;
}

/// Each part of an original's look is "file" or a value as at the root; lights may be the numbers of the file's own.
void read_look(const JsonNode& node, OriginalSource& source) {
  node.allow_only({"materials", "lights", "file_lights", "ambient", "background", "camera"});
  const auto is_file = [](const JsonNode& part) { return part.is_text() && part.text() == "file"; };
  if (const auto part = node.find("materials")) {
    if (!is_file(*part)) part->fail("must be 'file'");
    source.from_file.materials = true;
  }
  if (const auto part = node.find("lights")) read_lights(*part, source.appearance.lights);
  if (const auto part = node.find("file_lights")) {
    if (node.find("lights")) part->fail("stands beside 'lights': give one of the two");
    for (const JsonNode& number : part->items(1)) {
      source.from_file.lights.push_back(static_cast<u32>(number.count(0, 1'000'000)));
    }
  }
  const auto colour = [&](const char* key, bool& from_file, Vec3& value) {
    const auto part = node.find(key);
    if (!part) return;
    from_file = is_file(*part);
    if (!from_file) value = part->vector(0.0f, 1.0f);
  };
  colour("ambient", source.from_file.ambient, source.appearance.ambient);
  colour("background", source.from_file.background, source.appearance.background);
  if (const auto part = node.find("camera")) {
    source.from_file.camera = is_file(*part);
    if (!source.from_file.camera) read_camera(*part, source.appearance);
  }
}

OriginalSource read_original(const JsonNode& node, const Appearance& appearance) {
  node.allow_only({"file", "sha256", "triangles", "split_to", "sphere", "cone_slices", "fidelity", "change", "credit",
                   "home", "member", "look"});
  OriginalSource source;
  source.file = node.at("file").text();
  const bool climbs =
      std::any_of(source.file.begin(), source.file.end(), [](const auto& part) { return part == ".."; });
  if (source.file.is_absolute() || climbs) node.at("file").fail("must be a path inside the data folder");
  source.sha256 = node.at("sha256").text();
  if (source.sha256.size() != 64 || source.sha256.find_first_not_of("0123456789abcdef") != std::string::npos) {
    node.at("sha256").fail("must be 64 lower-case hex digits");
  }
  source.triangles = node.at("triangles").count(1, kMostTriangles);
  if (const auto split = node.find("split_to")) source.split_to = split->count(source.triangles, kMostTriangles);
  if (const auto sphere = node.find("sphere")) {
    const std::vector<JsonNode> counts = sphere->items(2);
    source.sphere.emplace(counts[0].count(3, 1000), counts[1].count(2, 1000));
  }
  if (const auto slices = node.find("cone_slices")) source.cone_slices = slices->count(0, 1000);
  const std::string fidelity = node.at("fidelity").text();
  if (fidelity != "original" && fidelity != "derived") node.at("fidelity").fail("must be 'original' or 'derived'");
  source.fidelity = fidelity == "original" ? Fidelity::kOriginal : Fidelity::kDerived;
  if (const auto change = node.find("change")) source.change = change->text();
  if (source.fidelity == Fidelity::kDerived && source.change.empty()) {
    node.fail("a derived scene must say in 'change' what differs");
  }
  source.credit = node.at("credit").text();
  if (const auto home = node.find("home")) source.home_url = home->text();
  if (node.find("member")) node.at("member").text();
  source.appearance = appearance;
  if (const auto look = node.find("look")) read_look(*look, source);
  if (source.appearance.materials.empty() && !source.from_file.materials) {
    node.fail("has no materials: neither the manifest's nor, by 'look', the file's");
  }
  return source;
}

void check_figures(const JsonNode& node, std::initializer_list<const char*> keys) {
  node.allow_only(keys);
  for (const char* key : keys) {
    const JsonNode figure = node.at(key);
    if (!figure.is_null()) figure.number(0.0f, 1e9f);
  }
}

/// The study's rows: where a table has a dash the figure is null.
void check_paper(const JsonNode& node) {
  node.allow_only({"source", "table1", "table2"});
  node.at("source").text();
  const JsonNode table1 = node.at("table1");
  table1.allow_only({"triangles", "lights", "grid_cells", "grid", "kdtree", "bvh"});
  table1.at("triangles").count(1, kMostTriangles);
  table1.at("lights").count(1, 1000);
  table1.at("grid_cells").vector(1.0f, 1e6f);
  const auto structure = {"references_per_triangle", "leaves_thousands", "size_mb", "steps_per_ray", "tests_per_ray"};
  for (const char* key : {"grid", "kdtree", "bvh"}) check_figures(table1.at(key), structure);
  const JsonNode table2 = node.at("table2");
  table2.allow_only({"primary_ms", "shadow_ms", "whitted_ms"});
  for (const char* key : {"primary_ms", "shadow_ms", "whitted_ms"}) {
    check_figures(table2.at(key), {"grid", "kdt-3", "kdt-2", "bvh"});
  }
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(stream);
  } catch (const nlohmann::json::parse_error& e) {
    throw std::runtime_error(file.string() + ": not JSON: " + e.what());
  }

  const JsonNode root(json, file.string());
  root.allow_only({"title", "prose", "source", "materials", "lights", "ambient", "background", "camera", "paper"});
  Manifest manifest;
  manifest.name = file.parent_path().filename().string();
  manifest.title = root.at("title").text();
  manifest.prose = root.at("prose").text();
  const JsonNode source = root.at("source");
  source.allow_only({"original", "generator"});
  manifest.appearance = read_appearance(root);
  if (const auto original = source.find("original")) manifest.original = read_original(*original, manifest.appearance);
  if (const auto generator = source.find("generator")) {
    manifest.generator = read_generator(*generator);
    if (manifest.appearance.materials.empty()) generator->fail("needs 'materials' in the manifest");
  }
  if (!manifest.original && !manifest.generator) source.fail("must have 'original', 'generator' or both");
  if (const auto paper = root.find("paper")) {
    check_paper(*paper);
    manifest.paper_json = paper->dump();
  }
  return manifest;
}

CameraPath Appearance::camera_path(const Box& bounds) const {
  if (const SplinePath* spline = std::get_if<SplinePath>(&camera)) return {*spline, frames};
  const OrbitPlan& plan = std::get<OrbitPlan>(camera);
  const Box box = bounds.empty() ? Box{{-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}} : bounds;
  const float radius = plan.radius_factor * 0.5f * length(box.extent());
  return {OrbitPath{plan.centre.value_or(box.centre()), radius, plan.elevation_deg, plan.start_deg, plan.turns,
                    plan.vertical_fov_deg},
          frames};
}

}  // namespace raywalk
