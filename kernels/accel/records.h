// What a triangle test reads of each triangle: its corners, or a transform that the builder made of them.
#pragma once
#include "kernels/query.h"

namespace raywalk {

/// The builders' option `triangles`; a structure holds records of one kind, and only tests that read those can use it.
enum class TriangleRecords : u32 { corners, transforms };

template <class Record>
constexpr TriangleRecords kRecords = TriangleRecords::corners;
template <>
inline constexpr TriangleRecords kRecords<Transform> = TriangleRecords::transforms;

/// Of all triangles, by id: the scene's own corners, or the transforms that the structure's header names.
template <class Query, class Header>
RW_FN const typename Query::Record* records_by_id(const u8* blob, SceneView scene) {
  if constexpr (kRecords<typename Query::Record> == TriangleRecords::transforms) {
    return data_of(blob, header_of<Header>(blob).transforms);
  } else {
    return scene.corners();
  }
}

}  // namespace raywalk
