#include "motion_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "json_place.hpp"

namespace taut::program {
namespace {

/// References, and what took each: none may be taken twice.
class Takers {
public:
  std::vector<int> references_at(const JsonPlace& place, const std::string& taker) {
    std::vector<int> references;
    place.for_each("a list of references", [&](const JsonPlace& entry) {
      const int reference = entry.reference();
      const auto [other, is_new] = takers_.try_emplace(reference, taker);
      if (!is_new) entry.fail(fmt::format("reference {} found again, after {}", reference, other->second));
      references.push_back(reference);
    });
    return references;
  }

private:
  std::map<int, std::string> takers_;
};

/// Calls make() and adds the place to its errors.
template <class Make>
RigidMotion motion_at(const JsonPlace& place, Make make) {
  try {
    return make();
  } catch (const InputError& error) {
    place.fail(error.what());
  }
}

RigidMotion translation_at(const JsonPlace& place) {
  const Point by = place.three_numbers();
  return motion_at(place, [&] { return RigidMotion::translation(by); });
}

RigidMotion rotation_at(const JsonPlace& place) {
  place.require_keys({"centre", "axis", "degrees"});
  const Point centre = place.at("centre").three_numbers(), axis = place.at("axis").three_numbers();
  const double degrees = place.at("degrees").number();
  // A share of more than half a turn would be a part of the shorter way, in the other direction.
  if (!(degrees >= -180 && degrees <= 180)) place.at("degrees").expected("a number from -180 to 180");
  return motion_at(place, [&] { return RigidMotion::rotation(centre, axis, degrees); });
}

/// Which one of the keys an object has.
std::string_view only_key(const JsonPlace& place, std::initializer_list<std::string_view> keys) {
  const auto is_there = [&](std::string_view key) { return place.has(key); };
  const auto count = std::count_if(keys.begin(), keys.end(), is_there);
  if (count != 1) place.fail(fmt::format("exactly one of {} expected, found {}", fmt::join(keys, ", "), count));
  return *std::find_if(keys.begin(), keys.end(), is_there);
}

/// The motion that a body or an entry of its list consists of.
RigidMotion motion_of(const JsonPlace& place, std::string_view key) {
  return key == "translation" ? translation_at(place.at(key)) : rotation_at(place.at(key));
}

std::vector<RigidMotion> motions_at(const JsonPlace& place) {
  std::vector<RigidMotion> motions;
  place.for_each("a list of motions", [&](const JsonPlace& entry) {
    entry.require_keys({"translation", "rotation"});
    motions.push_back(motion_of(entry, only_key(entry, {"translation", "rotation"})));
  });
  if (motions.empty()) place.expected("at least one motion");
  return motions;
}

MovingBody body_at(const JsonPlace& place, const std::string& name, Takers& takers,
                   const std::filesystem::path& folder) {
  place.require_keys({"references", "translation", "rotation", "motions", "displacements"});
  MovingBody body;
  body.references = takers.references_at(place.at("references"), name);
  if (body.references.empty()) place.at("references").expected("at least one reference");
  const std::string_view key = only_key(place, {"translation", "rotation", "motions", "displacements"});
  if (key == "displacements") {
    body.displacements = folder / place.at(key).text("the name of a file");
  } else if (key == "motions") {
    body.motions = motions_at(place.at(key));
  } else {
    body.motions = {motion_of(place, key)};
  }
  return body;
}

std::vector<int> references_if_any(const JsonPlace& root, const std::string& key, Takers& takers) {
  return root.has(key) ? takers.references_at(root.at(key), key) : std::vector<int>();
}

}  // namespace

RigidMotion MovingBody::place_after(double steps) const {
  RigidMotion place;
  for (const RigidMotion& motion : motions) place = motion.share(steps) * place;
  return place;
}

MotionFile read_motion(const std::filesystem::path& file) {
  const std::string name = file.string();
  const nlohmann::json json = read_json(name);
  const JsonPlace root(name, json);
  root.require_keys({"bodies", "fixed", "sliding"});
  MotionFile motion;
  Takers takers;
  root.at("bodies").for_each("a list of bodies", [&](const JsonPlace& place) {
    const std::string taker = fmt::format("bodies[{}]", motion.bodies.size());
    motion.bodies.push_back(body_at(place, taker, takers, file.parent_path()));
  });
  if (motion.bodies.empty()) root.at("bodies").expected("at least one body");
  motion.fixed = references_if_any(root, "fixed", takers);
  motion.sliding = references_if_any(root, "sliding", takers);
  return motion;
}

}  // namespace taut::program
