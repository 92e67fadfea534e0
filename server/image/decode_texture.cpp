// Reading images through OpenImageIO from memory.
#include "server/image/decode_texture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "server/image/srgb.h"

namespace raywalk {
namespace {

constexpr int kMostTexelsASide = 16'384;
constexpr u64 kMostLinearTexels = 1u << 25;  // twelve bytes each while they are converted
// What a header may claim: no format here packs a usual image tighter, and what lies is cheap up to that.
constexpr u64 kTexelsOfAnyFile = 1u << 24, kTexelsPerByte = 1024;

/// The name under which OpenImageIO knows the format; nullptr for one that is not read.
const char* format_of(std::span<const u8> bytes) {
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 18));
  if (head.starts_with("\xff\xd8\xff")) return "jpeg";
  if (head.starts_with("\x89PNG")) return "png";
  if (head.starts_with("BM")) return "bmp";
  if (head.starts_with("\x76\x2f\x31\x01")) return "openexr";
  if (head.starts_with("#?RADIANCE") || head.starts_with("#?RGBE")) return "hdr";
  if (head.size() > 2 && head[0] == 'P' && std::string_view("123456Ff").find(head[1]) != head.npos) return "pnm";
  // TGA has no magic number: kinds of colour map and of image, and bits per texel, that exist.
  if (head.size() < 18) return nullptr;
  const bool image = std::string_view("\x01\x02\x03\x09\x0a\x0b").find(head[2]) != head.npos;
  const bool depth = std::string_view("\x08\x0f\x10\x18\x20").find(head[16]) != head.npos;
  return static_cast<u8>(head[1]) <= 1 && image && depth ? "targa" : nullptr;
}

/// A file in memory, for readers that open files only.
class MemoryFile {
 public:
  explicit MemoryFile(std::span<const u8> bytes) : descriptor_(memfd_create("texture", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error("no memory for the image's file");
    for (size_t written = 0; written < bytes.size();) {
      const ssize_t count = write(descriptor_, bytes.data() + written, bytes.size() - written);
      if (count <= 0) {
        close(descriptor_);
        throw std::runtime_error("no memory for the image's file");
      }
      written += static_cast<size_t>(count);
    }
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

void check_size(const OIIO::ImageSpec& spec, u64 file_bytes) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1) {
    throw std::runtime_error("not a flat image with texels (" + size + ")");
  }
  if (std::max(spec.width, spec.height) > kMostTexelsASide) {
    throw std::runtime_error(size + " texels; the most is " + std::to_string(kMostTexelsASide) + " a side");
  }
  const u64 texels = static_cast<u64>(spec.width) * static_cast<u64>(spec.height);
  if (texels > kTexelsOfAnyFile + kTexelsPerByte * file_bytes) {
    throw std::runtime_error("a file of " + std::to_string(file_bytes) + " bytes does not hold " + size + " texels");
  }
  if (spec.format.is_floating_point() && texels > kMostLinearTexels) {
    throw std::runtime_error(size + " texels of floats; the most is " + std::to_string(kMostLinearTexels));
  }
}

/// What the reader has to say, which may be nothing.
std::runtime_error broken(const OIIO::ImageInput& in) {
  const std::string reason = in.geterror();
  return std::runtime_error(reason.empty() ? "the file is broken" : reason);
}

/// OpenImageIO reads a PNM file that ends early as if it went on.
void check_pnm_length(const OIIO::ImageSpec& spec, std::span<const u8> bytes) {
  const u64 width = static_cast<u64>(spec.width), height = static_cast<u64>(spec.height);
  const u64 values = width * height * static_cast<u64>(spec.nchannels);
  u64 least = values * spec.format.size();
  if (bytes[1] == '1') least = values;                             // a digit each
  if (bytes[1] == '2' || bytes[1] == '3') least = 2 * values - 1;  // and a space
  if (bytes[1] == '4') least = (width + 7) / 8 * height;
  constexpr u64 kLeastHeader = 7;  // "P1 1 1\n"
  if (bytes.size() < kLeastHeader + least) throw std::runtime_error("the file ends in the middle of the image");
}

/// A texel's red, green and blue bytes are the low ones of its word, in this order; of grey there is the red one only.
void read_integers(OIIO::ImageInput& in, int channels, std::vector<u32>& texels) {
  static_assert(std::endian::native == std::endian::little);
  if (!in.read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, texels.data(), sizeof(u32))) {
    throw broken(in);
  }
  if (channels > 1) return;
  for (u32& texel : texels) texel *= 0x010101u;
}

void read_floats(OIIO::ImageInput& in, int channels, std::vector<u32>& texels) {
  const size_t per_texel = static_cast<size_t>(channels);
  std::vector<float> linear(texels.size() * per_texel);
  if (!in.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, linear.data())) {
    throw broken(in);
  }
  std::vector<u8> encoded(linear.size());
  srgb_bytes(linear, encoded.data());
  for (size_t i = 0; i < texels.size(); ++i) {
    const u8* c = encoded.data() + i * per_texel;
    texels[i] = channels == 1 ? c[0] * 0x010101u : static_cast<u32>(c[0] | c[1] << 8 | c[2] << 16);
  }
}

}  // namespace

Texture decode_texture(std::span<const u8> bytes) {
  const char* format = format_of(bytes);
  if (format == nullptr) throw std::runtime_error("not an image of a known format");
  const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::create(format);
  if (!in) throw std::runtime_error(std::string("this build reads no ") + format + ": " + OIIO::geterror());

  OIIO::ImageSpec wish, spec;
  wish.attribute("oiio:UnassociatedAlpha", 1);  // else colours come multiplied with alpha
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  std::optional<MemoryFile> file;
  std::string path = "texture";
  if (!in->supports("ioproxy") || !in->set_ioproxy(&reader)) path = file.emplace(bytes).path();
  if (!in->open(path, spec, wish)) throw broken(*in);
  check_size(spec, bytes.size());
  if (std::string_view(format) == "pnm") check_pnm_length(spec, bytes);

  Texture texture{"", static_cast<u32>(spec.width), static_cast<u32>(spec.height), {}};
  texture.texels.resize(size_t{texture.width} * texture.height);
  const int channels = spec.nchannels < 3 ? 1 : 3;
  if (spec.format.is_floating_point()) {
    read_floats(*in, channels, texture.texels);
  } else {
    read_integers(*in, channels, texture.texels);
  }
  in->close();
  return texture;
}

}  // namespace raywalk
