// The only includer of OpenImageIO.
#include "server/image/encode.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <vector>

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

std::string write_viewable(const Frame& frame, Output output, bool jpeg) {
  const std::vector<u8> bytes = viewable(frame, output);
  OIIO::ImageSpec spec(static_cast<int>(frame.width), static_cast<int>(frame.height), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  if (jpeg) {
    spec.attribute("compression", "jpeg:90");
    spec.attribute("jpeg:subsampling", "4:2:0");
  } else {
    spec.attribute("png:compressionLevel", 1);
  }
  return write_image(jpeg ? "frame.jpg" : "frame.png", std::move(spec), OIIO::TypeDesc::UINT8, bytes.data());
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
    case ImageFormat::png:
      return write_viewable(frame, output, format == ImageFormat::jpeg);
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
