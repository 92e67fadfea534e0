// Sheets, rounded boxes, turned shapes, tubes and slabs.
#include "scenes/common/sheets.h"

#include <algorithm>

#include "scenes/common/catmull_rom.h"
#include "scenes/common/exact_math.h"

namespace raywalk {
namespace {

void add_cells(Pieces& pieces, PatchShape shape, Cells cells, u32 material) {
  const double columns = cells.columns, rows = cells.rows;
  pieces.patch(std::move(shape), static_cast<float>(columns / rows), material, 2.0 * columns * rows - 2.0);
}

struct Pole {
  float cosine, sine;
};
Pole pole(double turns) {
  return {static_cast<float>(cosine_turns(turns)), static_cast<float>(sine_turns(turns))};
}

/// Where `t` in [0, 1] falls among `segments`: number of the segment and the place in it.
struct OnChain {
  size_t segment;
  float u;
};
OnChain on_chain(size_t segments, float t) {
  const float x = t * static_cast<float>(segments);
  const size_t i = std::min(static_cast<size_t>(larger(x, 0.0f)), segments - 1);
  return {i, x - static_cast<float>(i)};
}

/// The axis that the chain of points keeps away from most.
Vec3 axis_off(const std::vector<Vec3>& points) {
  Vec3 most{};
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 d = normalized(points[i + 1] - points[i]);
    most = larger(most, larger(d, -d));
  }
  if (most.y <= most.x && most.y <= most.z) return {0.0f, 1.0f, 0.0f};
  return most.x <= most.z ? Vec3{1.0f, 0.0f, 0.0f} : Vec3{0.0f, 0.0f, 1.0f};
}

/// The rounded box: a grid of columns around the x axis and rows along it; whole numbers are its corners.
class RoundedBox {
 public:
  RoundedBox(Vec3 half, float round, u32 arc, Ends ends)
      : core_(half - Vec3{round, round, round}), round_(round), arc_(arc), skipped_rows_(ends == Ends::open ? 1 : 0) {}
  Cells cells() const { return {4 * (arc_ + 1), 2 * arc_ + 3 - 2 * skipped_rows_}; }

  SurfacePoint at(float u, float v) const {
    const auto [columns, rows] = cells();
    const OnChain c = on_chain(columns, u), r = on_chain(rows, v);
    const auto blend = [&](auto part) {
      const size_t row = r.segment + skipped_rows_;
      const Vec3 a = part(c.segment, row), b = part(c.segment + 1, row);
      const Vec3 e = part(c.segment, row + 1), f = part(c.segment + 1, row + 1);
      return (1.0f - r.u) * (a + c.u * (b - a)) + r.u * (e + c.u * (f - e));
    };
    return {blend([&](size_t i, size_t j) { return corner(i, j).position; }),
            normalized(blend([&](size_t i, size_t j) { return corner(i, j).normal; }))};
  }

 private:
  SurfacePoint corner(size_t column, size_t row) const {
    const size_t quarter = column / (arc_ + 1) % 4, step = column % (arc_ + 1);
    const Pole around = pole(0.25 * (static_cast<double>(quarter) + static_cast<double>(step) / arc_));
    const float side_y = quarter == 0 || quarter == 3 ? 1.0f : -1.0f, side_z = quarter < 2 ? 1.0f : -1.0f;

    const size_t last = 2 * arc_ + 3;
    if (row == 0 || row == last) {
      const float end = row == 0 ? -1.0f : 1.0f, nearly_closed = 0.02f;
      return {{end * (core_.x + round_), nearly_closed * side_y * core_.y, nearly_closed * side_z * core_.z},
              {end, 0.0f, 0.0f}};
    }
    const bool left = row <= arc_ + 1;
    const size_t steps = left ? row - 1 : last - 1 - row;
    const Pole along = pole(0.25 * static_cast<double>(steps) / arc_);  // from the end's plane to the side's
    const float end = left ? -1.0f : 1.0f;
    const Vec3 normal = {end * along.cosine, along.sine * around.cosine, along.sine * around.sine};
    return {Vec3{end * core_.x, side_y * core_.y, side_z * core_.z} + round_ * normal, normal};
  }

  Vec3 core_;
  float round_;
  u32 arc_, skipped_rows_;
};

}  // namespace

void add_sheet(Pieces& pieces, const PointShape& shape, Cells cells, u32 material) {
  const float du = 0.5f / static_cast<float>(cells.columns), dv = 0.5f / static_cast<float>(cells.rows);
  const auto with_normal = [=](float u, float v) {
    const auto across = [&](float at) { return shape(smaller(u + du, 1.0f), at) - shape(larger(u - du, 0.0f), at); };
    const Vec3 along = shape(u, smaller(v + dv, 1.0f)) - shape(u, larger(v - dv, 0.0f));
    Vec3 normal = cross(across(v), along);
    // At a point where the columns meet: as a little further in.
    if (!(length(normal) > 1e-12f)) normal = cross(across(v < 0.5f ? v + 0.1f * dv : v - 0.1f * dv), along);
    return SurfacePoint{shape(u, v), length(normal) > 1e-12f ? normalized(normal) : Vec3{0.0f, 1.0f, 0.0f}};
  };
  add_cells(pieces, with_normal, cells, material);
}

void add_pad(Pieces& pieces, const Placement& place, Vec3 centre, Vec3 half, float round, u32 material, u32 arc,
             Ends ends) {
  const RoundedBox box(half, round, arc, ends);
  const auto shape = [=](float u, float v) {
    const SurfacePoint p = box.at(u, v);
    return SurfacePoint{place.point(centre + p.position), place.direction(p.normal)};
  };
  add_cells(pieces, shape, box.cells(), material);
}

void add_lathe(Pieces& pieces, const Placement& place, const std::vector<ProfilePoint>& profile, u32 sides,
               u32 material) {
  const u32 rows = static_cast<u32>(profile.size() - 1);
  const auto shape = [=](float u, float v) {
    const auto [i, t] = on_chain(rows, v);
    const float radius = profile[i].radius + t * (profile[i + 1].radius - profile[i].radius);
    const float height = profile[i].height + t * (profile[i + 1].height - profile[i].height);
    const Pole p = pole(u);
    return place.point({radius * p.cosine, height, -radius * p.sine});
  };
  add_sheet(pieces, shape, {sides, rows}, material);
}

Vec3 curve_at(const std::vector<Vec3>& points, float t) {
  const auto [i, u] = on_chain(points.size() - 1, t);
  return catmull_rom([&](size_t k) { return points[k]; }, points.size(), i, u);
}

void add_tube(Pieces& pieces, const Placement& place, const std::vector<Vec3>& points, float radius, Cells cells,
              u32 material) {
  const Vec3 off = axis_off(points);
  const float step = 0.25f / static_cast<float>(cells.rows);
  const auto shape = [=](float u, float v) {
    const Vec3 along = normalized(curve_at(points, smaller(v + step, 1.0f)) - curve_at(points, larger(v - step, 0.0f)));
    const Vec3 side = normalized(cross(along, off)), other = cross(along, side);
    const Pole p = pole(u);
    const Vec3 normal = p.cosine * side + p.sine * other;
    return SurfacePoint{place.point(curve_at(points, v) + radius * normal), place.direction(normal)};
  };
  add_cells(pieces, shape, cells, material);
}

void add_slab(Pieces& pieces, const Placement& place, const std::function<Vec3(float t)>& outline, Vec3 middle,
              float bottom, float top, u32 chords, u32 material) {
  const Vec3 up = {0.0f, 1.0f, 0.0f};
  const auto flat = [&](float height, bool from_above) {
    const auto shape = [=](float u, float v) {
      const float out = from_above ? 1.0f - v : v;
      const Vec3 p = middle + (0.01f + 0.99f * out) * (outline(u) - middle);
      return SurfacePoint{place.point(p + height * up), from_above ? up : -up};
    };
    add_cells(pieces, shape, {chords, 1}, material);
  };
  flat(top, true);
  flat(bottom, false);
  const auto rim = [=](float u, float v) { return place.point(outline(u) + (bottom + v * (top - bottom)) * up); };
  add_sheet(pieces, rim, {chords, 1}, material);
}

void add_block(Pieces& pieces, const Placement& place, Vec3 lo, Vec3 hi, u32 material) {
  add_box(pieces, place, lo, hi, material, 0.0);
}

void add_plate(Pieces& pieces, Vec3 corner, Vec3 edge_u, Vec3 edge_v, u32 material) {
  add_quad(pieces, corner, edge_u, edge_v, material, 0.0);
}

}  // namespace raywalk
