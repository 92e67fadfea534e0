// The kernels' own kinds on the CPU: one blob each.
#include "server/device/cpu/cpu_kind.h"
#include "server/device/knobs.h"

namespace raywalk {
namespace {

class BlobStructure final : public CpuStructure {
 public:
  BlobStructure(std::shared_ptr<const Blob> scene, std::string kind, BuiltStructure built)
      : CpuStructure(std::move(scene), std::move(kind), built.stats), blob_(std::move(built.blob)), form_(built.form) {}
  const void* handle() const override { return blob_.data(); }
  StructureForm form() const override { return form_; }

 private:
  Blob blob_;
  StructureForm form_;
};

std::shared_ptr<const CpuStructure> build_blob(std::shared_ptr<const Blob> scene, const Kind* kind,
                                               const OptionValues& options) {
  BuiltStructure built = kind->build(SceneView{scene->data()}, with_defaults(*kind, options));
  return std::make_shared<BlobStructure>(std::move(scene), std::string(kind->name), std::move(built));
}

}  // namespace

std::vector<CpuKind> kernel_kinds() {
  std::vector<CpuKind> all;
  for (const Kind* kind : kinds()) {
    CpuKind cpu{{std::string(kind->name), std::string(kind->help), kind->options, {}}, build_blob, kind, {}};
    for (const CpuTraversal& row : cpu_traversals()) {
      if (row.kind != kind->name) continue;
      cpu.info.traversals.push_back({std::string(row.name), std::string(row.help), false, knob_options(row.knobs)});
      cpu.traversals.push_back(row);
    }
    all.push_back(std::move(cpu));
  }
  return all;
}

}  // namespace raywalk
