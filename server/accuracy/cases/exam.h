// One hard case asked of one technique: what the functions of the cases work with.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "server/accuracy/cases/hard_cases.h"
#include "server/accuracy/cases/meshes.h"

namespace raywalk::accuracy {

using SceneBlob = std::shared_ptr<const Blob>;
using StructureRef = std::shared_ptr<const Structure>;
using OnDevice = std::function<void(const std::function<void(Device&)>&)>;

/// The kind that every scene can be asked of without a structure.
constexpr std::string_view kBruteForce = "brute";

/// A scene as it is packed elsewhere: triangles without an area have NaN vertices.
SceneBlob scene_of(Mesh mesh);

/// What the techniques of one case share: scenes with what is known of them, and structures.
class CaseStore {
 public:
  /// The value under `key`, made at its first use. A key has one type.
  template <class Make>
  const std::invoke_result_t<Make>& get(const std::string& key, Make make) {
    using Value = std::invoke_result_t<Make>;
    std::shared_ptr<const void>& value = values_[key];
    if (!value) value = std::make_shared<const Value>(make());
    return *static_cast<const Value*>(value.get());
  }
  StructureRef& structure(const SceneBlob& scene, const std::string& kind, const OptionValues& options) {
    return structures_[{scene, kind, options}];
  }
  void clear() {
    values_.clear();
    structures_.clear();
  }

 private:
  std::map<std::string, std::shared_ptr<const void>> values_;
  std::map<std::tuple<SceneBlob, std::string, OptionValues>, StructureRef> structures_;
};

/// An answer that is wrong, and how to tell whether fewer triangles and simpler numbers still give one.
struct Failure {
  std::string what;
  Ray ray;
  Mesh triangles = {};  // those concerned; ids are their places in the scene
  std::function<bool(const Ray& ray, const Mesh& triangles)> still_fails = {};  // empty: as it is
};

class Exam {
 public:
  Exam(const OnDevice& on_device, const SuiteSpec& spec, const Technique& technique, CaseStore& store,
       CaseOutcome& outcome);

  const Technique& technique() const { return technique_; }
  bool strict() const { return strict_; }
  bool is_brute() const { return technique_.structure == kBruteForce; }
  bool can_count() const { return can_count_; }
  /// Of the builder; nullptr when it has none of this name.
  const Option* build_option(std::string_view name) const;
  /// How many rays stand for the `full` number; at least `least`.
  u32 count(u64 full, u64 least = 32) const;
  /// The same for rays that are not shared between techniques: of one that is not strict a twentieth is enough.
  u32 own_count(u64 full) const { return count(strict_ ? full : full / 20); }
  /// Of one stream of random numbers, the same for every technique.
  u32 seed(u32 stream) const { return static_cast<u32>(seed_ * 0x9e3779b1u + 8191u * number_ + stream); }
  Random random(u32 stream) const { return Random(seed(stream)); }
  CaseStore& store() { return store_; }

  /// The technique's structure, with options of the builder replaced that it has.
  StructureRef build(const SceneBlob& scene, const OptionValues& more = {});
  std::vector<Hit> closest(const StructureRef& structure, const std::vector<Ray>& rays);
  std::vector<u8> occluded(const StructureRef& structure, const std::vector<Ray>& rays);
  std::vector<Counts> count_work(const StructureRef& structure, const std::vector<Ray>& rays);
  Frame render(FrameJob job);
  /// By brute force with the technique's triangle test.
  std::vector<Hit> brute_force(const SceneBlob& scene, const std::vector<Ray>& rays);
  /// Of a few triangles with new ids, by a structure that is not kept.
  std::vector<Hit> closest_among(const Mesh& triangles, const std::vector<Ray>& rays);

  /// Counts rays; those of repeated questions about the same ray are not counted.
  void add_rays(u64 rays) { outcome_.rays += rays; }
  /// Counts a failure; the first one is described by `describe`, shrunk when the technique is strict.
  void fail(const std::function<Failure()>& describe);
  /// A failure that has no ray.
  void fail(const std::string& what);
  void does_not_apply(const std::string& why) { outcome_.why_not = why; }

 private:
  RayJob job(const StructureRef& structure, const std::vector<Ray>& rays) const;
  std::vector<Hit> checked(std::vector<Hit> hits);

  const OnDevice& on_device_;
  const Technique& technique_;
  CaseStore& store_;
  CaseOutcome& outcome_;
  double scale_;
  u64 seed_;
  u32 number_;
  bool strict_, can_count_ = false;
  KindInfo kind_, brute_;
};

}  // namespace raywalk::accuracy
