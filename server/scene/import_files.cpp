// Confined lookup and counted reading.
#include "server/scene/import_files.h"

#include <algorithm>
#include <stdexcept>

#include "server/scene/byte_reader.h"
#include "server/scene/text.h"

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
  // What is checked is what is read: through links "a/.." need not be where it stands.
  const fs::path file = (folder / slashed).lexically_normal();
  const fs::path real = fs::weakly_canonical(file, error);
  if (error) return std::nullopt;
  const auto is_outside = [&](const fs::path& path) {
    return std::mismatch(root_.begin(), root_.end(), path.begin(), path.end()).first != root_.end();
  };
  const bool absolute = fs::path(slashed).is_absolute();
  if (!absolute && is_outside(fs::weakly_canonical(folder.lexically_normal(), error))) return std::nullopt;
  if (absolute || is_outside(real)) {
    throw std::runtime_error(in_quotes(slashed) + " lies outside the scene's folder");
  }
  if (!fs::is_regular_file(real, error)) return std::nullopt;
  return file;
}

std::string ImportFiles::read(const fs::path& file) {
  ByteReader reader(file);
  std::string bytes;
  bytes.reserve(std::min(reader.likely_bytes_left(), bytes_left_));
  constexpr size_t kStep = 1 << 16;
  for (std::span<const u8> next = reader.peek_some(kStep); !next.empty(); next = reader.peek_some(kStep)) {
    if (next.size() > bytes_left_) {
      throw std::runtime_error(file.string() + ": the scene's files hold more than " +
                               std::to_string(settings_.limits.bytes) + " bytes");
    }
    bytes_left_ -= next.size();
    bytes.append(reinterpret_cast<const char*>(next.data()), next.size());
    reader.skip(next.size());
  }
  return bytes;
}

Texture ImportFiles::decode(std::span<const u8> bytes) const {
  if (!settings_.decode) throw std::runtime_error("no decoder of images");
  return settings_.decode(bytes);
}

}  // namespace raywalk
