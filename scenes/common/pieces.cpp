// Sharing a number of triangles among pieces.
#include <stdexcept>
#include <string>

#include "scenes/common/surface.h"

namespace raywalk {

void Pieces::patch(PatchShape shape, float aspect, u32 material, double weight, u64 least) {
  pieces_.push_back({std::move(shape), {}, aspect, material, weight, least});
}

void Pieces::ball(BallShape shape, u32 material, double weight) {
  pieces_.push_back({{}, std::move(shape), 1.0f, material, weight, kLeastBallTriangles});
}

void Pieces::append(const Pieces& other) {
  pieces_.insert(pieces_.end(), other.pieces_.begin(), other.pieces_.end());
}

u64 Pieces::least_triangles() const {
  u64 sum = 0;
  for (const Piece& piece : pieces_) sum += piece.least;
  return sum;
}

void Pieces::add_to(TriangleSink& sink, u64 triangles) const {
  const u64 least = least_triangles();
  if (triangles < least) {
    throw std::invalid_argument(std::to_string(triangles) + " triangles are fewer than " + std::to_string(least));
  }
  double weights = 0.0;
  for (const Piece& piece : pieces_) weights += piece.weight;
  const double spare = static_cast<double>(triangles - least);
  const auto share = [&](const Piece& piece) {
    const u64 more = static_cast<u64>(spare * (piece.weight / weights));
    return piece.least + (piece.patch ? more : more / 2 * 2);
  };

  u64 shared = 0;
  const Piece* heaviest_patch = nullptr;
  for (const Piece& piece : pieces_) {
    shared += share(piece);
    if (piece.patch && (heaviest_patch == nullptr || piece.weight > heaviest_patch->weight)) heaviest_patch = &piece;
  }
  // What rounding leaves over, one or two a piece, goes where it shows least.
  const u64 rest = triangles - shared;
  for (const Piece& piece : pieces_) {
    if (piece.patch) {
      add_patch(sink, piece.patch, piece.aspect, piece.material, share(piece) + (&piece == heaviest_patch ? rest : 0));
    } else {
      add_ball(sink, piece.ball, piece.material, share(piece));
    }
  }
}

}  // namespace raywalk
