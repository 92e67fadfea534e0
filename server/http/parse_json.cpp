// nlohmann's parser, with an eye on depth and on fields that come twice.
#include "server/http/parse_json.h"

#include <cctype>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "server/http/problem.h"

namespace raywalk::http {
namespace {

constexpr int kMaxDepth = 32;

/// Follows the parser through objects and arrays.
class Watch {
 public:
  void see(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > kMaxDepth) {
      throw ApiError(400, "malformed_json", "The JSON is nested deeper than " + std::to_string(kMaxDepth) + " levels.");
    }
    using Event = Json::parse_event_t;
    if (event == Event::key) {
      see_key(parsed.get_ref<const std::string&>());
    } else if (event == Event::object_end || event == Event::array_end) {
      open_.pop_back();
    } else {
      if (!open_.empty() && open_.back().is_array) open_.back().step = std::to_string(open_.back().items++);
      if (event != Event::value) open_.push_back({event == Event::array_start, 0, {}, {}});
    }
  }

 private:
  struct Level {
    bool is_array;
    std::size_t items;
    std::string step;  // where the parser is below this level
    std::set<std::string> names;
  };

  void see_key(const std::string& name) {
    open_.back().step = name;
    if (open_.back().names.insert(name).second) return;
    Json::json_pointer pointer;
    for (const Level& level : open_) pointer.push_back(level.step);
    throw ApiError(400, "duplicate_field", "The JSON has the field '" + name + "' twice in one object.",
                   {{pointer.to_string(), "is there twice"}});
  }

  std::vector<Level> open_;
};

void make_whole_numbers_integers(Json& value) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    if (std::abs(number) < 9.0e15 && std::floor(number) == number) value = static_cast<std::int64_t>(number);
  } else if (value.is_structured()) {
    for (Json& child : value) make_whole_numbers_integers(child);
  }
}

/// `at` is the number of bytes that were read when the parser gave up.
std::string reason(std::string_view text, std::size_t at, std::string_view parser_words) {
  if (parser_words.find("surrogate") != std::string_view::npos) return "half of a surrogate pair";
  if (parser_words.find("UTF-8") != std::string_view::npos) return "not UTF-8";
  if (at == 0 || at > text.size()) return "it ends too early";
  const char c = text[at - 1];
  if (std::isgraph(static_cast<unsigned char>(c))) return std::string("unexpected '") + c + "'";
  return "unexpected character";
}

}  // namespace

Json parse_json(std::string_view text) {
  if (text.empty()) throw ApiError(400, "malformed_json", "The body is empty; JSON is expected.");
  Watch watch;
  try {
    Json value = Json::parse(text, [&](int depth, Json::parse_event_t event, Json& parsed) {
      watch.see(depth, event, parsed);
      return true;
    });
    make_whole_numbers_integers(value);
    return value;
  } catch (const Json::parse_error& e) {
    throw ApiError(
        400, "malformed_json",
        "The body is not JSON at byte " + std::to_string(e.byte) + ": " + reason(text, e.byte, e.what()) + ".");
  } catch (const Json::out_of_range&) {
    throw ApiError(400, "malformed_json", "The JSON has a number that is too large for 64-bit floating point.");
  }
}

}  // namespace raywalk::http
