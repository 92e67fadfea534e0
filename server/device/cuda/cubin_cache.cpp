// A cache file: magic, SHA-256 of all that follows in hex digits, key, reports, cubin. Numbers are little-endian, as
// every machine that runs this is.
#include "server/device/cuda/cubin_cache.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <sstream>

#include "server/system/sha256.h"

namespace raywalk::cuda {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "raywalk cubin 1\n";
constexpr size_t kDigestSize = 64;

std::string digest_of(std::string_view contents) {
  Sha256 digest;
  digest.add(contents.data(), contents.size());
  return digest.hex();
}

void put(std::string& out, u64 number) {
  out.append(reinterpret_cast<const char*>(&number), sizeof number);
}
void put(std::string& out, std::string_view text) {
  put(out, u64{text.size()});
  out.append(text);
}

/// Takes values off the front; `good` turns false at the first that is not there.
struct Reader {
  std::string_view rest;
  bool good = true;

  std::string_view bytes(u64 size) {
    good = good && size <= rest.size();
    if (!good) return {};
    const std::string_view taken = rest.substr(0, size);
    rest.remove_prefix(size);
    return taken;
  }
  u64 number() {
    const std::string_view raw = bytes(sizeof(u64));
    u64 value = 0;
    if (good) std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }
  std::string_view text() { return bytes(number()); }
  u32 figure() { return static_cast<u32>(number()); }
};

std::string contents_of(const std::string& key, const Compiled& compiled) {
  std::string out;
  put(out, key);
  put(out, u64{compiled.entries.size()});
  for (const EntryReport& e : compiled.entries) {
    put(out, e.entry);
    for (const u32 figure : {e.registers, e.stack_bytes, e.spill_store_bytes, e.spill_load_bytes, e.shared_bytes}) {
      put(out, u64{figure});
    }
  }
  put(out, std::string_view(compiled.cubin.data(), compiled.cubin.size()));
  return out;
}

/// Nothing when the file is damaged, of another format, or of another key.
std::optional<Compiled> parse(std::string_view file, const std::string& key) {
  Reader reader{file};
  if (reader.bytes(kMagic.size()) != kMagic) return std::nullopt;
  const std::string_view digest = reader.bytes(kDigestSize);
  if (digest != digest_of(reader.rest) || reader.text() != key) return std::nullopt;

  Compiled compiled{.cubin = {}, .entries = {}, .cached = true};
  const u64 count = reader.number();
  for (u64 i = 0; i < count && reader.good; ++i) {
    EntryReport& e = compiled.entries.emplace_back();
    e.entry = reader.text();
    for (u32* figure : {&e.registers, &e.stack_bytes, &e.spill_store_bytes, &e.spill_load_bytes, &e.shared_bytes}) {
      *figure = reader.figure();
    }
  }
  const std::string_view cubin = reader.text();
  if (!reader.good || !reader.rest.empty()) return std::nullopt;
  compiled.cubin.assign(cubin.begin(), cubin.end());
  return compiled;
}

/// Differs between threads and processes.
std::string unique_suffix() {
  static std::atomic<u64> number = 0;
  return '.' + std::to_string(getpid()) + '.' + std::to_string(number++) + ".new";
}

}  // namespace

CubinCache::CubinCache(fs::path dir) : dir_(std::move(dir)) {
  if (dir_.empty()) return;
  std::error_code error;
  fs::create_directories(dir_, error);
  if (error) cannot_write(error.message());
}

fs::path CubinCache::file_of(const std::string& key) const {
  return dir_ / (key + ".kernel");
}

std::optional<Compiled> CubinCache::load(const std::string& key) const {
  if (dir_.empty()) return std::nullopt;
  std::ifstream in(file_of(key), std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream file;
  file << in.rdbuf();  // of a folder, or where reading fails, as much as there is
  std::optional<Compiled> compiled = parse(file.str(), key);
  if (!compiled) {
    spdlog::warn("kernel cache: {} is damaged or of another version; it is made anew", file_of(key).string());
  }
  return compiled;
}

void CubinCache::store(const std::string& key, const Compiled& compiled) const {
  if (dir_.empty()) return;
  const std::string contents = contents_of(key, compiled);
  fs::path partial = file_of(key);
  partial += unique_suffix();
  std::ofstream out(partial, std::ios::binary);
  out << kMagic << digest_of(contents) << contents;
  out.close();
  std::error_code error;
  if (out) fs::rename(partial, file_of(key), error);
  if (out && !error) return;
  cannot_write(error ? error.message() : "writing failed");
  fs::remove(partial, error);
}

void CubinCache::cannot_write(const std::string& reason) const {
  if (warned_.exchange(true)) return;
  spdlog::warn("kernel cache: {} cannot be written ({}); kernels are compiled at every start", dir_.string(), reason);
}

}  // namespace raywalk::cuda
