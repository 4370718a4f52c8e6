#include "local_file.hpp"

#include <charconv>
#include <initializer_list>
#include <map>
#include <string_view>

#include "json_place.hpp"

namespace taut::program {
namespace {

int reference_in(const std::string& key, const JsonPlace& place) {
  int reference = 0;
  const char* end = key.data() + key.size();
  const auto [last, error] = std::from_chars(key.data(), end, reference);
  if (error != std::errc{} || last != end) place.fail("a reference, which is a 32-bit integer, expected as this key");
  return reference;
}

LocalSize size_at(const JsonPlace& place, bool of_triangles) {
  if (of_triangles) {
    place.require_keys({"size", "min", "max", "deviation"});
  } else {
    place.require_keys({"size", "min", "max"});
  }
  if (place.size() == 0) place.expected("at least one of the keys size, min, max");
  LocalSize size;
  const auto read = [&](const char* key, double& number) {
    if (!place.has(key)) return;
    number = place.at(key).number();
    if (!(number > 0)) place.at(key).expected("a number above 0");
  };
  read("size", size.size);
  read("min", size.min);
  read("max", size.max);
  read("deviation", size.deviation);
  return size;
}

std::map<int, LocalSize> sizes_at(const JsonPlace& root, std::string_view kind) {
  std::map<int, LocalSize> sizes;
  if (!root.has(kind)) return sizes;
  root.at(kind).for_each_key("an object with references as keys", [&](const std::string& key, const JsonPlace& place) {
    const LocalSize size = size_at(place, kind == "triangles");
    if (!sizes.try_emplace(reference_in(key, place), size).second) place.fail("this reference was given before");
  });
  return sizes;
}

}  // namespace

LocalSizes read_local_sizes(const std::string& file) {
  const nlohmann::json json = read_json(file);
  const JsonPlace root(file, json);
  root.require_keys({"points", "edges", "triangles", "tetrahedra"});
  LocalSizes sizes;
  sizes.points = sizes_at(root, "points");
  sizes.edges = sizes_at(root, "edges");
  sizes.triangles = sizes_at(root, "triangles");
  sizes.tetrahedra = sizes_at(root, "tetrahedra");
  if (sizes.empty()) root.expected("sizes for at least one reference");
  return sizes;
}

}  // namespace taut::program
