// One call of NVRTC a kernel, unless the cache has it.
#include "server/device/cuda/compiler.h"

#include "server/device/cuda/assembler_log.h"
#include "server/device/cuda/cubin_cache.h"
#include "server/device/cuda/nvrtc_api.h"
#include "server/device/cuda/sources.h"
#include "server/system/sha256.h"

namespace raywalk::cuda {
namespace {

std::string program_file(Program program) {
  return "kernels/gpu/" + std::string(name_of(program)) + ".cu";
}

constexpr int kFirstWithCache = 13;  // version of NVRTC

/// No contraction and no fast mathematics: results are the CPU's, bit for bit.
std::vector<std::string> options_of(const NvrtcApi& nvrtc, const KernelSpec& spec, const std::string& architecture) {
  const auto number = [](const char* name, u32 value) {
    return "-D" + std::string(name) + '=' + std::to_string(value);
  };
  std::vector<std::string> options = {
      "-default-device",
      "-std=c++20",
      "--fmad=false",
      "--ftz=false",
      "--prec-div=true",
      "--prec-sqrt=true",
      "--ptxas-options=-v",
      "--gpu-architecture=" + architecture,
      "-DRW_TRAVERSAL=" + spec.traversal,
      "-DRW_INTERSECTOR=" + spec.intersector,
      "-DRW_SLAB=" + spec.slab,
      "-DRW_NODES=" + spec.nodes,
      "-DRW_SPAWN=" + spec.spawn,
      number("RW_FEATURES", spec.features) + 'u',
      number("RW_MODE", static_cast<u32>(spec.mode)) + 'u',
      number("RW_BLOCK", spec.block) + 'u',
      number("RW_STACK_ENTRIES", spec.stack_entries) + 'u',
      number("RW_REGISTERS", spec.registers),
  };
  // A kernel out of NVRTC's own cache comes without the assembler's log.
  if (nvrtc.major >= kFirstWithCache) options.push_back("--no-cache");
  return options;
}

/// The source of one program with all headers.
struct Sources {
  const char* program = nullptr;
  std::vector<const char*> headers, names;
};

Sources sources_of(const std::string& program) {
  Sources sources;
  for (const Source& file : kernel_sources()) {
    if (file.name == program) {
      sources.program = file.text;
    } else if (std::string_view(file.name).ends_with(".h")) {
      sources.headers.push_back(file.text);
      sources.names.push_back(file.name);
    }
  }
  return sources;
}

/// Everything that the machine code depends on.
std::string key_of(const NvrtcApi& nvrtc, const Sources& sources, const std::vector<std::string>& options) {
  Sha256 digest;
  const auto add = [&](std::string_view text) {
    const u64 size = text.size();
    digest.add(&size, sizeof size);
    digest.add(text.data(), text.size());
  };
  add(nvrtc.version());
  add(nvrtc.identity);
  add(sources.program);
  for (size_t i = 0; i < sources.names.size(); ++i) {
    add(sources.names[i]);
    add(sources.headers[i]);
  }
  for (const std::string& option : options) add(option);
  return digest.hex();
}

/// An NVRTC program, destroyed when it goes.
class NvrtcProgram {
 public:
  NvrtcProgram(const NvrtcApi& api, const Sources& sources, const std::string& name) : api_(api) {
    expect(api_.nvrtcCreateProgram(&program_, sources.program, name.c_str(), static_cast<int>(sources.names.size()),
                                   sources.headers.data(), sources.names.data()),
           "nvrtcCreateProgram");
  }
  ~NvrtcProgram() { api_.nvrtcDestroyProgram(&program_); }
  NvrtcProgram(const NvrtcProgram&) = delete;
  NvrtcProgram& operator=(const NvrtcProgram&) = delete;

  nvrtcResult compile(const std::vector<std::string>& options) {
    std::vector<const char*> texts;
    for (const std::string& option : options) texts.push_back(option.c_str());
    return api_.nvrtcCompileProgram(program_, static_cast<int>(texts.size()), texts.data());
  }
  std::string log() const {
    size_t size = 0;
    expect(api_.nvrtcGetProgramLogSize(program_, &size), "nvrtcGetProgramLogSize");
    std::string text(size, '\0');
    expect(api_.nvrtcGetProgramLog(program_, text.data()), "nvrtcGetProgramLog");
    while (!text.empty() && (text.back() == '\0' || text.back() == '\n')) text.pop_back();
    return text;
  }
  std::vector<char> cubin() const {
    size_t size = 0;
    expect(api_.nvrtcGetCUBINSize(program_, &size), "nvrtcGetCUBINSize");
    std::vector<char> bytes(size);
    expect(api_.nvrtcGetCUBIN(program_, bytes.data()), "nvrtcGetCUBIN");
    return bytes;
  }

 private:
  void expect(nvrtcResult result, const char* call) const {
    if (result != NVRTC_SUCCESS) throw CompileError(std::string(call) + ": " + api_.nvrtcGetErrorString(result));
  }

  const NvrtcApi& api_;
  nvrtcProgram program_ = nullptr;
};

}  // namespace

Compiler::Compiler(std::shared_ptr<const NvrtcApi> nvrtc, std::string architecture, std::filesystem::path cache_dir)
    : nvrtc_(std::move(nvrtc)),
      architecture_(std::move(architecture)),
      cache_(std::make_unique<CubinCache>(std::move(cache_dir))) {}

Compiler::~Compiler() = default;

Compiled Compiler::compile(const KernelSpec& spec) const {
  const std::string file = program_file(spec.program);
  const Sources sources = sources_of(file);
  const std::vector<std::string> options = options_of(*nvrtc_, spec, architecture_);
  const std::string key = key_of(*nvrtc_, sources, options);
  if (std::optional<Compiled> kept = cache_->load(key)) return std::move(*kept);

  NvrtcProgram program(*nvrtc_, sources, file);
  if (const nvrtcResult result = program.compile(options); result != NVRTC_SUCCESS) {
    throw CompileError("The kernel " + spec.name() + " does not compile for " + architecture_ + ": " +
                       nvrtc_->nvrtcGetErrorString(result) + ".\n" + program.log());
  }
  const Compiled compiled{.cubin = program.cubin(), .entries = read_assembler_log(program.log()), .cached = false};
  cache_->store(key, compiled);
  return compiled;
}

}  // namespace raywalk::cuda
