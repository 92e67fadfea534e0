// Media ranges with their weights.
#include "server/api/accept.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace raywalk::api {
namespace {

struct Range {
  std::string type;
  double weight = 1;
};

std::string trimmed_lower(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '\t') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(trimmed_lower(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

/// 3 for the very type, 2 for its family, 1 for everything, 0 for no match.
int specificity(const std::string& range, const std::string& type) {
  if (range == type) return 3;
  if (range == "*/*") return 1;
  return range.ends_with("/*") && type.starts_with(range.substr(0, range.size() - 1)) ? 2 : 0;
}

double weight_of(const std::vector<Range>& ranges, const std::string& type) {
  int best = 0;
  double weight = 0;
  for (const Range& range : ranges) {
    if (const int s = specificity(range.type, type); s > best) {
      best = s;
      weight = range.weight;
    }
  }
  return weight;
}

}  // namespace

std::optional<std::string> negotiate(const std::string& accept, const std::vector<std::string>& offered) {
  std::vector<Range> ranges;
  for (const std::string& item : split(accept, ',')) {
    const std::vector<std::string> parts = split(item, ';');
    if (parts[0].empty()) continue;
    Range range{parts[0]};
    for (const std::string& parameter : parts) {
      if (parameter.starts_with("q=")) range.weight = std::strtod(parameter.c_str() + 2, nullptr);
    }
    ranges.push_back(std::move(range));
  }
  if (ranges.empty()) return offered.front();
  std::optional<std::string> best;
  double best_weight = 0;
  for (const std::string& type : offered) {
    if (const double weight = weight_of(ranges, type); weight > best_weight) {
      best = type;
      best_weight = weight;
    }
  }
  return best;
}

}  // namespace raywalk::api
