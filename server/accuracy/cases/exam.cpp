// Asks a device what a case wants to know.
#include "server/accuracy/cases/exam.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/accuracy/cases/hex.h"
#include "server/accuracy/cases/shrink.h"
#include "server/scene/degenerate.h"

namespace raywalk::accuracy {
namespace {

const KindInfo& info_of(const Device& device, std::string_view name) {
  for (const KindInfo& kind : device.kinds())
    if (kind.name == name) return kind;
  throw std::invalid_argument("the device has no structure " + std::string(name));
}

const Option* find(const std::vector<Option>& options, std::string_view name) {
  const auto found = std::ranges::find(options, name, &Option::name);
  return found == options.end() ? nullptr : &*found;
}

/// Those of `values` that are among `options`.
OptionValues known(const std::vector<Option>& options, const OptionValues& values) {
  OptionValues result;
  for (const auto& [name, value] : values)
    if (find(options, name)) result.emplace(name, value);
  return result;
}

}  // namespace

SceneBlob scene_of(Mesh mesh) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (Corners& t : mesh)
    if (is_finite(t) && is_degenerate(t)) t.a = t.b = t.c = {kNan, kNan, kNan};
  return std::make_shared<const Blob>(make_scene(std::move(mesh)));
}

Exam::Exam(const OnDevice& on_device, const SuiteSpec& spec, const Technique& technique, CaseStore& store,
           CaseOutcome& outcome)
    : on_device_(on_device),
      technique_(technique),
      store_(store),
      outcome_(outcome),
      scale_(spec.rays),
      seed_(spec.seed),
      number_(outcome.number),
      strict_(is_strict(technique)) {
  on_device_([&](Device& device) {
    kind_ = info_of(device, technique_.structure);
    brute_ = info_of(device, kBruteForce);
    can_count_ = device.can_count(technique_.structure);
  });
}

const Option* Exam::build_option(std::string_view name) const {
  return find(kind_.options, name);
}

u32 Exam::count(u64 full, u64 least) const {
  return static_cast<u32>(std::max(static_cast<double>(least), std::ceil(static_cast<double>(full) * scale_)));
}

StructureRef Exam::build(const SceneBlob& scene, const OptionValues& more) {
  OptionValues options = technique_.options;
  for (const auto& [name, value] : known(kind_.options, more)) options[name] = value;
  StructureRef& structure = store_.structure(scene, kind_.name, options);
  if (!structure) on_device_([&](Device& device) { structure = device.build(scene, kind_.name, options); });
  return structure;
}

RayJob Exam::job(const StructureRef& structure, const std::vector<Ray>& rays) const {
  return {structure, technique_.traversal, rays, technique_.kernel};
}

std::vector<Hit> Exam::checked(std::vector<Hit> hits) {
  for (const Hit& hit : hits)
    outcome_.nans += hit.id != kMiss && (std::isnan(hit.t) || std::isnan(hit.u) || std::isnan(hit.v)) ? 1 : 0;
  return hits;
}

std::vector<Hit> Exam::closest(const StructureRef& structure, const std::vector<Ray>& rays) {
  std::vector<Hit> hits;
  on_device_([&](Device& device) { hits = device.closest(job(structure, rays)); });
  return checked(std::move(hits));
}

std::vector<u8> Exam::occluded(const StructureRef& structure, const std::vector<Ray>& rays) {
  std::vector<u8> flags;
  on_device_([&](Device& device) { flags = device.occluded(job(structure, rays)); });
  return flags;
}

std::vector<Counts> Exam::count_work(const StructureRef& structure, const std::vector<Ray>& rays) {
  std::vector<Counts> counts;
  on_device_([&](Device& device) { counts = device.count_rays(job(structure, rays)); });
  return counts;
}

Frame Exam::render(FrameJob frame_job) {
  frame_job.traversal = technique_.traversal;
  frame_job.kernel = technique_.kernel;
  Frame frame;
  on_device_([&](Device& device) { device.render(frame_job, frame); });
  return frame;
}

std::vector<Hit> Exam::brute_force(const SceneBlob& scene, const std::vector<Ray>& rays) {
  const TraversalInfo& loop = brute_.traversals.front();
  const OptionValues options = known(brute_.options, technique_.options);
  StructureRef& structure = store_.structure(scene, brute_.name, options);
  std::vector<Hit> hits;
  on_device_([&](Device& device) {
    if (!structure) structure = device.build(scene, brute_.name, options);
    hits = device.closest({structure, loop.name, rays, known(loop.options, technique_.kernel)});
  });
  return hits;
}

std::vector<Hit> Exam::closest_among(const Mesh& triangles, const std::vector<Ray>& rays) {
  std::vector<Hit> hits;
  const SceneBlob scene = scene_of(triangles);
  on_device_(
      [&](Device& device) { hits = device.closest(job(device.build(scene, kind_.name, technique_.options), rays)); });
  return hits;
}

void Exam::fail(const std::function<Failure()>& describe) {
  if (outcome_.failures++ == 0) {
    Failure failure = describe();
    if (strict_) failure = shrunk(std::move(failure));
    outcome_.first_failure = text_of(failure);
  }
}

void Exam::fail(const std::string& what) {
  if (outcome_.failures++ == 0) outcome_.first_failure = what;
}

}  // namespace raywalk::accuracy
