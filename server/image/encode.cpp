// The only includer of OpenImageIO.
#include "server/image/encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "server/image/jpeg_strips.h"
#include "server/image/viewable.h"

namespace raywalk {
namespace {

std::string write_image(const char* file_name, OIIO::ImageSpec spec, OIIO::TypeDesc type, const void* pixels) {
  const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(file_name);
  if (!out) throw std::runtime_error(std::string("OpenImageIO cannot write ") + file_name);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput target(bytes);
  if (!out->set_ioproxy(&target) || !out->open(file_name, spec) || !out->write_image(type, pixels) || !out->close()) {
    throw std::runtime_error(std::string("cannot encode ") + file_name + ": " + out->geterror());
  }
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

OIIO::ImageSpec eight_bit(const Frame& frame, u32 rows) {
  return {static_cast<int>(frame.width), static_cast<int>(rows), 3, OIIO::TypeDesc::UINT8};
}

/// Strips in parallel: one thread alone takes longer to encode a preview than a GPU to render it.
std::string write_jpeg(const Frame& frame, Output output) {
  const std::vector<u8> bytes = viewable(frame, output);
  std::vector<std::string> strips((frame.height + kJpegStripRows - 1) / kJpegStripRows);
  tbb::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t i) {
    const u32 first = static_cast<u32>(i) * kJpegStripRows;
    OIIO::ImageSpec spec = eight_bit(frame, std::min(kJpegStripRows, frame.height - first));
    spec.attribute("compression", "jpeg:90");
    spec.attribute("jpeg:subsampling", "4:2:0");
    const u8* rows = bytes.data() + std::size_t{3} * frame.width * first;
    strips[i] = write_image("frame.jpg", std::move(spec), OIIO::TypeDesc::UINT8, rows);
  });
  return strips.size() == 1 ? std::move(strips[0]) : join_jpeg_strips(strips, frame.height);
}

std::string write_png(const Frame& frame, Output output) {
  OIIO::ImageSpec spec = eight_bit(frame, frame.height);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 1);
  return write_image("frame.png", std::move(spec), OIIO::TypeDesc::UINT8, viewable(frame, output).data());
}

std::string write_exr(const Frame& frame, Output output) {
  const bool half = output == Output::color || output == Output::normal;
  OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), static_cast<int>(frame.channels),
                       half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  if (frame.channels == 1) spec.channelnames = {output == Output::depth ? "Z" : "id"};
  if (frame.channels == 2) spec.channelnames = {"steps", "tests"};
  spec.attribute("compression", "zip");
  return write_image("frame.exr", std::move(spec), OIIO::TypeDesc::FLOAT, frame.pixels.data());
}

}  // namespace

std::string encode(const Frame& frame, Output output, ImageFormat format) {
  switch (format) {
    case ImageFormat::jpeg:
      return write_jpeg(frame, output);
    case ImageFormat::png:
      return write_png(frame, output);
    case ImageFormat::exr:
      return write_exr(frame, output);
    case ImageFormat::raw:
      break;
  }
  return {reinterpret_cast<const char*>(frame.pixels.data()), frame.pixels.size() * sizeof(float)};
}

std::string image_library_version() {
  return OIIO_VERSION_STRING;
}

}  // namespace raywalk
