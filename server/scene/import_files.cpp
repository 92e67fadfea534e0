// Confined lookup and counted reading.
#include "server/scene/import_files.h"

#include <algorithm>
#include <stdexcept>

#include "server/scene/byte_reader.h"

namespace raywalk {

namespace fs = std::filesystem;

ImportFiles::ImportFiles(const fs::path& main, ImportSettings settings)
    : main_(main),
      settings_(std::move(settings)),
      root_(fs::weakly_canonical(settings_.root.empty() ? fs::absolute(main).parent_path() : settings_.root)),
      bytes_left_(settings_.limits.bytes) {}

std::optional<fs::path> ImportFiles::find(std::string_view name, const fs::path& folder) const {
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  // A name with a zero byte would be cut short by the system.
  if (slashed.empty() || slashed.find('\0') != slashed.npos) return std::nullopt;
  std::error_code error;
  const fs::path file = folder / slashed;
  const fs::path real = fs::weakly_canonical(file, error);
  if (error) return std::nullopt;
  const auto [end_of_root, unused] = std::mismatch(root_.begin(), root_.end(), real.begin(), real.end());
  if (fs::path(slashed).is_absolute() || end_of_root != root_.end()) {
    throw std::runtime_error("'" + slashed + "' lies outside the scene's folder");
  }
  if (!fs::is_regular_file(real, error)) return std::nullopt;
  return file.lexically_normal();
}

std::string ImportFiles::read(const fs::path& file) {
  ByteReader reader(file);
  std::string bytes;
  bytes.reserve(std::min(reader.likely_bytes_left(), bytes_left_));
  constexpr size_t kStep = 1 << 16;
  for (size_t step = kStep; step > 0;) {
    const u8* next = reader.peek(step);
    if (next == nullptr) {
      step /= 2;
      continue;
    }
    if (step > bytes_left_) {
      throw std::runtime_error(file.string() + ": the scene's files hold more than " +
                               std::to_string(settings_.limits.bytes) + " bytes");
    }
    bytes_left_ -= step;
    bytes.append(reinterpret_cast<const char*>(next), step);
    reader.skip(step);
  }
  return bytes;
}

Texture ImportFiles::decode(std::span<const u8> bytes) const {
  if (!settings_.decode) throw std::runtime_error("no decoder of images");
  return settings_.decode(bytes);
}

}  // namespace raywalk
