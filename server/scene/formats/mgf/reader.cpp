// Statements, files, transformations and objects.
#include "server/scene/formats/mgf/reader.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "server/scene/formats/mgf/numbers.h"
#include "server/scene/text.h"

namespace raywalk {
namespace {

constexpr size_t kDeepestNesting = 1000;  // of xf, and of o
constexpr size_t kDeepestInclude = 64;
constexpr u64 kMostWork = 500'000'000;  // bytes that arrays and includes read again
constexpr u64 kWorkOfStatement = 64;    // a statement costs like so many bytes
constexpr u64 kWorkOfInclude = 10'000;  // and finding its file like so many
constexpr size_t kAny = 1'000'000;

}  // namespace

std::span<const MgfReader::Entity> MgfReader::entities() {
  using R = MgfReader;
  static constexpr Entity kEntities[] = {
      {"c", 0, 3, &R::color},
      {"cct", 1, 1, &R::color_temperature},
      {"cmix", 2, kAny, &R::color_mixture},
      {"cone", 4, 4, &R::cone},
      {"cspec", 4, kAny, &R::color_spectrum},
      {"cxy", 2, 2, &R::color_xy},
      {"cyl", 3, 3, &R::cylinder},
      {"ed", 1, 1, &R::emitted},
      {"f", 3, kAny, &R::face},
      {"i", 1, kAny, &R::include},
      {"ies", 1, kAny, &R::skip},
      {"ir", 2, 2, &R::refraction},
      {"m", 0, 3, &R::material},
      {"n", 3, 3, &R::normal},
      {"o", 0, kAny, &R::object},
      {"p", 3, 3, &R::point},
      {"prism", 4, kAny, &R::prism},
      {"rd", 1, 1, &R::diffuse},
      {"ring", 3, 3, &R::ring},
      {"rs", 2, 2, &R::specular},
      {"sides", 1, 1, &R::sides},
      {"sph", 2, 2, &R::sphere},
      {"td", 1, 1, &R::translucent},
      {"torus", 3, 3, &R::torus},
      {"ts", 2, 2, &R::transparent},
      {"v", 0, 3, &R::vertex},
      {"xf", 0, kAny, &R::transform},
  };
  static_assert(std::ranges::is_sorted(kEntities, {}, &Entity::name));
  return kEntities;
}

MgfReader::MgfReader(ImportFiles& files)
    : files_(files), builder_(files), geometry_(builder_, files.settings()), work_left_(kMostWork) {}

Scene MgfReader::read() {
  const Source& main = source(files_.main());
  try {
    run(main);
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(at_line(place_.file, place_.line) + ": " + e.what());
  }
  emitters_.finish(builder_, files_.main().string());
  if (!builder_.scene().lights.empty()) {
    // A room: what the lamps do not reach is not dark, and its windows look at the sky.
    builder_.scene().ambient = {0.3f, 0.3f, 0.3f};
    builder_.scene().background = {0.35f, 0.5f, 0.75f};
  }
  return builder_.finish();
}

const MgfReader::Source& MgfReader::source(const std::filesystem::path& path) {
  const auto known = sources_.find(path);
  if (known != sources_.end()) return known->second;
  return sources_.emplace(path, Source{path, files_.read(path)}).first->second;
}

void MgfReader::run(const Source& source) {
  StatementReader statements(source.text);
  StatementReader* const outer = std::exchange(statements_, &statements);
  const size_t frames = frames_.size(), objects = objects_.size();
  open_files_.push_back(&source);
  place_.file = source.path;
  std::vector<std::string_view> words;
  for (;;) {
    const u64 from = statements.mark().offset;
    place_.line = statements.mark().line + 1;  // should the next one be no statement
    const bool more = statements.next(words);
    charge(statements.mark().offset - from);
    if (!more) break;
    place_.line = statements.line();
    execute(words);
  }
  if (frames_.size() > frames) {
    place_.line = frames_.back().line;
    throw std::runtime_error("this 'xf' is not closed");
  }
  if (objects_.size() > objects) {
    warn(std::to_string(objects_.size() - objects) + " objects are not closed");
    objects_.resize(objects);
  }
  open_files_.pop_back();
  statements_ = outer;
}

void MgfReader::execute(Words words) {
  const std::span<const Entity> known = entities();
  const auto entity = std::ranges::lower_bound(known, words[0], {}, &Entity::name);
  if (entity == known.end() || entity->name != words[0]) {
    return warn(in_quotes(words[0]) + " is no statement of MGF");
  }
  const Words arguments = words.subspan(1);
  if (arguments.size() < entity->least || arguments.size() > entity->most) {
    std::string takes = std::to_string(entity->least);
    if (entity->most == kAny) takes.append(" or more");
    if (entity->most != kAny && entity->most != entity->least)
      takes.append(" to ").append(std::to_string(entity->most));
    throw std::runtime_error(in_quotes(entity->name) + " takes " + takes + " arguments, not " +
                             std::to_string(arguments.size()));
  }
  (this->*entity->run)(arguments);
}

/// Arrays and includes may ask for more than anybody can wait for.
void MgfReader::charge(u64 bytes) {
  if (repeating_ == 0) return;
  const u64 work = bytes + kWorkOfStatement;
  if (work > work_left_) throw std::runtime_error("arrays and includes repeat too much");
  work_left_ -= work;
}

void MgfReader::open_frame(Words arguments, const StatementReader* statements) {
  if (frames_.size() == kDeepestNesting) {
    throw std::runtime_error("transformations are nested more than " + std::to_string(kDeepestNesting) + " deep");
  }
  const StatementReader::Mark begin = statements != nullptr ? statements->mark() : StatementReader::Mark{};
  frames_.push_back({MgfTransform(arguments), glm::dmat4(1.0), statements, begin, place_.line});
  place();
}

/// The current frame's next member of its arrays; false after the last.
bool MgfReader::next_member() {
  Frame& frame = frames_.back();
  if (!frame.transform.next()) return false;
  if (!frame.again) ++repeating_;
  frame.again = true;
  charge(kWorkOfStatement * frame.transform.parts());
  place();
  return true;
}

void MgfReader::close_frame() {
  if (frames_.back().again) --repeating_;
  frames_.pop_back();
  geometry_.place(frames_.empty() ? glm::dmat4(1.0) : frames_.back().total);
}

/// An inner transformation comes before those outside.
void MgfReader::place() {
  Frame& frame = frames_.back();
  const glm::dmat4 outer = frames_.size() > 1 ? frames_[frames_.size() - 2].total : glm::dmat4(1.0);
  frame.total = outer * frame.transform.matrix();
  geometry_.place(frame.total);
}

void MgfReader::transform(Words arguments) {
  if (!arguments.empty()) return open_frame(arguments, statements_);
  if (frames_.empty() || frames_.back().statements != statements_) {
    throw std::runtime_error("this 'xf' closes none that was opened in its file");
  }
  if (next_member()) {
    statements_->go_to(frames_.back().begin);
  } else {
    close_frame();
  }
}

void MgfReader::include(Words arguments) {
  const std::optional<std::filesystem::path> found = files_.find(arguments[0], open_files_.back()->path.parent_path());
  if (!found) throw std::runtime_error("there is no file " + in_quotes(arguments[0]) + " to include");
  const bool again = sources_.contains(*found);
  const Source& included = source(*found);
  if (std::ranges::find(open_files_, &included) != open_files_.end()) {
    throw std::runtime_error(in_quotes(arguments[0]) + " includes itself");
  }
  if (open_files_.size() == kDeepestInclude) {
    throw std::runtime_error("files are included more than " + std::to_string(kDeepestInclude) + " deep");
  }
  const auto place = place_;
  if (again) ++repeating_;
  charge(kWorkOfInclude);
  open_frame(arguments.subspan(1), nullptr);
  do {
    run(included);
    place_ = place;
  } while (next_member());
  close_frame();
  if (again) --repeating_;
}

void MgfReader::object(Words arguments) {
  if (arguments.empty()) {
    if (objects_.empty()) return warn("this 'o' closes no object");
    return objects_.pop_back();
  }
  if (objects_.size() == kDeepestNesting) {
    throw std::runtime_error("objects are nested more than " + std::to_string(kDeepestNesting) + " deep");
  }
  objects_.push_back(++last_object_);
}

void MgfReader::skip(Words arguments) {
  warn("the luminaire " + in_quotes(arguments[0]) + " is left out");
}

}  // namespace raywalk
