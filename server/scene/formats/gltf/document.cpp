// tinygltf between the checks before it and files that are confined and counted.
#include "server/scene/formats/gltf/document.h"

#include <limits>
#include <new>
#include <stdexcept>

#include "server/scene/formats/gltf/precheck.h"

namespace raywalk::gltf {
namespace {

/// The images are decoded when a material needs them; those in a buffer stay there.
bool keep_bytes(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// `user` in what follows.
ImportFiles& files_of(void* user) {
  return *static_cast<ImportFiles*>(user);
}

std::optional<std::filesystem::path> find(const std::string& name, void* user) {
  return files_of(user).find(name, files_of(user).main().parent_path());
}

bool file_exists(const std::string& name, void* user) {
  return find(name, user).has_value();
}

std::string unchanged(const std::string& name, void*) {
  return name;
}

bool read_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& name, void* user) {
  const std::optional<std::filesystem::path> file = find(name, user);
  if (!file) {
    *error = "there is no such file";
    return false;
  }
  const std::string text = files_of(user).read(*file);
  bytes->assign(text.begin(), text.end());
  return true;
}

/// A template, because later versions of tinygltf have one member more.
template <class Callbacks>
Callbacks callbacks_on(ImportFiles& files) {
  Callbacks callbacks{};
  callbacks.FileExists = file_exists;
  callbacks.ExpandFilePath = unchanged;
  callbacks.ReadWholeFile = read_file;
  if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
    callbacks.GetFileSizeInBytes = [](size_t* size, std::string*, const std::string& name, void* user) {
      const std::optional<std::filesystem::path> file = find(name, user);
      if (file) *size = std::filesystem::file_size(*file);
      return file.has_value();
    };
  }
  callbacks.user_data = &files;
  return callbacks;
}

/// One line of what may be several.
std::string one_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  for (char& c : text) c = c == '\n' ? ' ' : c;
  return text.empty() ? "not a glTF file" : text;
}

}  // namespace

void Document::fail(const std::string& part, const std::string& what) const {
  throw std::runtime_error(at(part) + ": " + what);
}

std::span<const u8> Document::bytes_of(const tinygltf::Image& image) const {
  if (image.bufferView < 0) return image.image;
  // Checked before the file was read.
  const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(image.bufferView)];
  return std::span(model.buffers[static_cast<size_t>(view.buffer)].data).subspan(view.byteOffset, view.byteLength);
}

Document open_document(ImportFiles& files) {
  Document document{files.main().string(), {}};
  const std::string bytes = files.read(files.main());
  if (bytes.size() > std::numeric_limits<u32>::max()) throw std::runtime_error(document.file + ": 4 GiB or more");
  check_json(json_text(bytes, document.file), document.file);

  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_bytes, nullptr);
  loader.SetFsCallbacks(callbacks_on<tinygltf::FsCallbacks>(files));
  std::string error, warning;
  const u32 size = static_cast<u32>(bytes.size());
  bool done = false;
  try {
    done = bytes.starts_with("glTF")
               ? loader.LoadBinaryFromMemory(&document.model, &error, &warning,
                                             reinterpret_cast<const unsigned char*>(bytes.data()), size)
               : loader.LoadASCIIFromString(&document.model, &error, &warning, bytes.data(), size, "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw std::runtime_error(document.file + ": " + e.what());
  }
  if (!done) throw std::runtime_error(document.file + ": " + one_line(error));
  return document;
}

}  // namespace raywalk::gltf
