// Files, blocks and the statements that are no geometry.
#include "server/scene/formats/aff/reader.h"

#include <algorithm>

namespace raywalk::aff {
namespace {

constexpr double kRest = 0.0;  // the time at which objects are shown
constexpr size_t kMostFilesDeep = 64;
constexpr u64 kMostIncludes = 20'000;
constexpr long long kMostDetail = 1'000'000;
constexpr u32 kWalkthroughFrames = 400;

}  // namespace

Reader::Reader(ImportFiles& files)
    : files_(files),
      builder_(files),
      materials_(builder_),
      geometry_(builder_),
      shapes_(geometry_, materials_, files.settings(), kRest),
      bytes_left_(files.limits().bytes) {}

const Reader::Statement* Reader::find(std::string_view word) {
  static constexpr Statement kStatements[] = {
      {"v", &Reader::read_view},
      {"l", &Reader::read_light},
      {"la", &Reader::read_named_light},
      {"b", &Reader::read_background},
      {"am", &Reader::read_ambient},
      {"f", &Reader::read_fill},
      {"fm", &Reader::read_full_fill},
      {"s", &Reader::read_sphere},
      {"c", &Reader::read_cone},
      {"p", &Reader::read_flat_polygon},
      {"pp", &Reader::read_smooth_polygon},
      {"tt", &Reader::read_flat_triangle},
      {"ttp", &Reader::read_smooth_triangle},
      {"tpa", &Reader::read_animated_triangle},
      {"m", &Reader::read_mesh},
      {"i", &Reader::read_include},
      {"d", &Reader::read_detail},
      {"xs", &Reader::read_fixed_block},
      {"x", &Reader::read_animated_block},
      {"a", &Reader::read_timetable},
      {"k", &Reader::read_keyframes},
  };
  const auto found = std::find_if(std::begin(kStatements), std::end(kStatements),
                                  [&](const Statement& statement) { return statement.word == word; });
  return found == std::end(kStatements) ? nullptr : found;
}

Scene Reader::read() {
  builder_.scene().ambient = {1, 1, 1};  // where the file does not say
  read_file(files_.main(), files_.main().string());
  if (!understood_) throw std::runtime_error(files_.main().string() + ": there is no AFF statement in it");
  finish();
  return builder_.finish();
}

const std::string& Reader::content_of(const std::filesystem::path& file) {
  const auto [known, is_new] = contents_.try_emplace(file);
  if (is_new) known->second = files_.read(file);
  return known->second;
}

void Reader::read_file(const std::filesystem::path& file, const std::string& named_at) {
  const std::string& content = content_of(file);
  // A file counts each time it is read again: includes multiply.
  if (content.size() > bytes_left_) throw Error(named_at + ": the included files hold too much together");
  bytes_left_ -= content.size();
  including_.push_back(file);
  Text text(file, content);
  try {
    read_statements(text);
  } catch (const Error&) {
    throw;
  } catch (const std::runtime_error& e) {
    text.fail(e.what());
  }
  including_.pop_back();
}

void Reader::read_statements(Text& text) {
  const size_t depth_of_file = geometry_.depth();
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    if (word == "}") {
      close_block(text, depth_of_file);
    } else if (const Statement* statement = find(word)) {
      (this->*statement->read)(text);
      understood_ = true;
    } else {
      builder_.warn(text.place(), "unknown statement " + in_quotes(word) + " is skipped");
      text.skip_statement();
    }
  }
  if (geometry_.depth() > depth_of_file) text.fail("the file ends inside braces");
}

void Reader::close_block(Text& text, size_t depth_of_file) {
  if (geometry_.depth() == depth_of_file) text.fail("there is no block for this brace to close");
  geometry_.close();
}

void Reader::read_include(Text& text) {
  const long long level = text.integer("level of detail");
  const std::string_view name = text.name("a file");
  if (level > detail_) return;
  const std::optional<std::filesystem::path> file = files_.find(name, text.file().parent_path());
  if (!file) text.fail("there is no file " + in_quotes(name));
  if (std::find(including_.begin(), including_.end(), *file) != including_.end()) {
    text.fail(in_quotes(name) + " includes itself");
  }
  if (including_.size() == kMostFilesDeep) {
    text.fail("files include each other more than " + std::to_string(kMostFilesDeep) + " deep");
  }
  if (++includes_ > kMostIncludes) text.fail("more than " + std::to_string(kMostIncludes) + " files are included");
  read_file(*file, text.place());
}

void Reader::read_detail(Text& text) {
  detail_ = std::min(text.integer("level of detail"), kMostDetail);
}

void Reader::read_fixed_block(Text& text) {
  const glm::dvec3 scale = text.point("scale"), axis = text.point("axis");
  const double angle_deg = text.real("angle");
  const glm::dvec3 position = text.point("translation");
  text.expect("{");
  geometry_.open(placement(position, turn(axis, angle_deg), scale));
}

void Reader::read_animated_block(Text& text) {
  const std::string place = text.place();
  const std::string_view name = text.name("a name");
  text.expect("{");
  geometry_.open(name, place);
}

void Reader::read_keyframes(Text& text) {
  const std::string name(text.name("a name"));
  const std::string place = text.place();
  Keyframes keyframes = aff::read_keyframes(text);
  if (keyframes.left_out > 0) {
    builder_.warn(place, std::to_string(keyframes.left_out) + " keys of " + in_quotes(name) +
                             " are left out: their times go back");
  }
  keyframes_.insert_or_assign(name, std::move(keyframes));
}

void Reader::read_timetable(Text& text) {
  const double start = text.real("start");
  const double end = text.real("end");
  if (end < start) text.fail("the animation ends before it begins");
  if (text.integer("number of frames") < 1) text.fail("an animation without frames");
  timetable_ = {start, end};
}

void Reader::read_view(Text& text) {
  View view{};
  text.expect("from");
  view.from = text.point("from");
  text.expect("at");
  view.at = text.point("at");
  text.expect("up");
  view.up = text.point("up");
  text.expect("angle");
  view.angle_deg = text.real("angle");
  if (!(view.angle_deg > 0.0 && view.angle_deg < 180.0))
    text.fail("the angle of view is not between 0 and 180 degrees");
  text.expect("hither");
  text.real("hither");  // rays know no near plane
  text.expect("resolution");
  text.real("width");
  text.real("height");
  view_ = view;
}

Vec3 Reader::optional_color(Text& text) {
  return text.next_is_number() ? text.color("colour") : Vec3{1, 1, 1};
}

void Reader::read_light(Text& text) {
  const glm::dvec3 position = text.point("position");
  geometry_.add_light(position, optional_color(text));
}

void Reader::read_named_light(Text& text) {
  const std::string place = text.place();
  geometry_.open(text.name("a name"), place);
  read_light(text);
  geometry_.close();
}

void Reader::read_background(Text& text) {
  builder_.scene().background = text.color("background");
}

void Reader::read_ambient(Text& text) {
  builder_.scene().ambient = text.color("ambient light");
}

void Reader::finish() {
  if (const u64 cones = shapes_.cones_left_out(); cones > 0) {
    builder_.warn(files_.main().string(), std::to_string(cones) + " cones are left out, as asked for");
  }
  geometry_.settle(keyframes_, kRest);
  Scene& scene = builder_.scene();
  const auto camera = keyframes_.find("camera");
  if (timetable_ && camera != keyframes_.end()) {
    const float fov_deg = view_ ? static_cast<float>(view_->angle_deg) : CameraPose{}.vertical_fov_deg;
    scene.camera_path = {
        KeyframedPath{timetable_->start, timetable_->end, camera->second.position, camera->second.rotation, fov_deg},
        kWalkthroughFrames};
    scene.has_camera_path = true;
  } else if (view_) {
    const auto narrow = [](const glm::dvec3& v) {
      return Vec3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    builder_.add_camera(
        {"view", {narrow(view_->from), narrow(view_->at), narrow(view_->up), static_cast<float>(view_->angle_deg)}});
  }
}

}  // namespace raywalk::aff
