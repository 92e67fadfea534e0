// Buffer views, component types, sparse values.
#include "server/scene/formats/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace raywalk::gltf {
namespace {

constexpr u64 kMostWithoutBuffer = 1u << 20;  // zeros that the file need not hold

/// Elements at equal distances, all within the buffer.
struct Elements {
  const u8* first;
  size_t stride;
};

class AccessorReader {
 public:
  AccessorReader(const Document& document, int index, const std::string& part)
      : document_(document),
        part_(part),
        index_(index),
        accessor_(document.element(document.model.accessors, index, "accessor", part)) {}

  u64 count() const { return accessor_.count; }

  template <class T>
  std::vector<T> read(u32 components) const {
    const int has = tinygltf::GetNumComponentsInType(static_cast<u32>(accessor_.type));
    if (has != static_cast<int>(components)) {
      fail("has " + std::to_string(has) + " components, not " + std::to_string(components));
    }
    const size_t bytes = component_bytes(accessor_.componentType) * components;
    std::vector<T> values;
    if (accessor_.bufferView >= 0) {
      const Elements elements = find(accessor_.bufferView, accessor_.byteOffset, bytes, count(), true);
      values.resize(count() * components);
      convert(elements, accessor_.componentType, components, count(), values.data());
    } else {
      if (count() > kMostWithoutBuffer) fail("has " + std::to_string(count()) + " values, and no bufferView");
      values.resize(count() * components);
    }
    if (accessor_.sparse.isSparse) replace_sparse(components, bytes, values);
    return values;
  }

  [[noreturn]] void fail(const std::string& what) const {
    document_.fail(part_, "accessor " + std::to_string(index_) + " " + what);
  }

 private:
  size_t component_bytes(int type) const {
    switch (type) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
      case TINYGLTF_COMPONENT_TYPE_SHORT:
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
      default:
        fail("has the unknown component type " + std::to_string(type));
    }
  }

  Elements find(int view_index, u64 offset, size_t bytes, u64 elements, bool strided) const {
    if (view_index < 0 || static_cast<size_t>(view_index) >= document_.model.bufferViews.size()) {
      fail("has no bufferView " + std::to_string(view_index));
    }
    const tinygltf::BufferView& view = document_.model.bufferViews[static_cast<size_t>(view_index)];
    if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= document_.model.buffers.size()) {
      fail("has no buffer " + std::to_string(view.buffer));
    }
    const std::vector<unsigned char>& data = document_.model.buffers[static_cast<size_t>(view.buffer)].data;
    const u64 stride = strided && view.byteStride > 0 ? view.byteStride : bytes;
    const bool view_fits = view.byteLength <= data.size() && view.byteOffset <= data.size() - view.byteLength;
    // No product overflows: a stride and a count beyond the buffer's size are refused before.
    const bool fits = view_fits && stride >= bytes && stride <= 0xffff && offset <= view.byteLength &&
                      elements <= view.byteLength &&
                      (elements == 0 || (elements - 1) * stride + bytes <= view.byteLength - offset);
    if (!fits) fail("lies outside bufferView " + std::to_string(view_index));
    return {data.data() + view.byteOffset + offset, stride};
  }

  /// A fraction of the type's largest value if the accessor is normalised.
  template <class From, class T>
  T converted(From value) const {
    if constexpr (std::is_same_v<T, float> && std::is_integral_v<From>) {
      if (accessor_.normalized) {
        return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<From>::max()), -1.0f);
      }
    }
    return static_cast<T>(value);
  }

  template <class From, class T>
  void convert_from(Elements elements, u32 components, u64 count, T* values) const {
    for (u64 i = 0; i < count; ++i) {
      const u8* element = elements.first + i * elements.stride;
      for (u32 c = 0; c < components; ++c) {
        From value;
        std::memcpy(&value, element + c * sizeof(From), sizeof(From));
        *values++ = converted<From, T>(value);
      }
    }
  }

  template <class T>
  void convert(Elements elements, int type, u32 components, u64 count, T* values) const {
    switch (type) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return convert_from<u8>(elements, components, count, values);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return convert_from<std::uint16_t>(elements, components, count, values);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return convert_from<u32>(elements, components, count, values);
      default:
        break;
    }
    if constexpr (std::is_same_v<T, float>) {
      if (type == TINYGLTF_COMPONENT_TYPE_BYTE) return convert_from<std::int8_t>(elements, components, count, values);
      if (type == TINYGLTF_COMPONENT_TYPE_SHORT) return convert_from<std::int16_t>(elements, components, count, values);
      return convert_from<float>(elements, components, count, values);
    }
    fail("has indices that are not unsigned integers");
  }

  template <class T>
  void replace_sparse(u32 components, size_t bytes, std::vector<T>& values) const {
    const auto& sparse = accessor_.sparse;
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
      fail("has a negative sparse count or offset");
    }
    const u64 replaced = static_cast<u64>(sparse.count);
    const size_t index_bytes = component_bytes(sparse.indices.componentType);
    const Elements at =
        find(sparse.indices.bufferView, static_cast<u64>(sparse.indices.byteOffset), index_bytes, replaced, false);
    const Elements by =
        find(sparse.values.bufferView, static_cast<u64>(sparse.values.byteOffset), bytes, replaced, false);
    std::vector<u32> indices(replaced);
    convert(at, sparse.indices.componentType, 1, replaced, indices.data());
    for (u64 i = 0; i < replaced; ++i) {
      if (indices[i] >= count()) fail("has the sparse index " + std::to_string(indices[i]));
      convert(Elements{by.first + i * by.stride, by.stride}, accessor_.componentType, components, 1,
              values.data() + u64{indices[i]} * components);
    }
  }

  const Document& document_;
  const std::string& part_;
  int index_;
  const tinygltf::Accessor& accessor_;
};

}  // namespace

u64 value_count(const Document& document, int index, const std::string& part) {
  return AccessorReader(document, index, part).count();
}

std::vector<float> read_values(const Document& document, int index, u32 components, const std::string& part) {
  const AccessorReader reader(document, index, part);
  std::vector<float> values = reader.read<float>(components);
  const auto bad = std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (bad != values.end()) {
    reader.fail("is not finite in value " + std::to_string((bad - values.begin()) / components));
  }
  return values;
}

std::vector<u32> read_indices(const Document& document, int index, u64 limit, const std::string& part) {
  const AccessorReader reader(document, index, part);
  std::vector<u32> indices = reader.read<u32>(1);
  const auto bad = std::find_if(indices.begin(), indices.end(), [&](u32 value) { return value >= limit; });
  if (bad != indices.end()) {
    reader.fail("names vertex " + std::to_string(*bad) + " of " + std::to_string(limit));
  }
  return indices;
}

}  // namespace raywalk::gltf
