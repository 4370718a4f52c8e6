// Hand-made bytes of Gamma Mesh Format files, in any version and byte order, valid or not.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/fields.hpp"
#include "io/gmf_file.hpp"
#include "io/read_mesh.hpp"
#include "mesh/expect_equal.hpp"
#include "taut/io.hpp"

namespace taut::test {

/// Writes the keywords of a binary file one after another. Positions of next keywords are filled in when they are
/// known.
class GmfBuilder {
public:
  explicit GmfBuilder(int version, std::endian order = std::endian::little) : version_(version), order_(order) {
    word(1).word(version);
  }

  GmfBuilder& keyword(int code) {
    link();
    word(code);
    pending_ = bytes_.size();
    return position(0);
  }
  GmfBuilder& dimension(int value = 3) { return keyword(3).word(value); }
  GmfBuilder& block(int code, std::int64_t count) { return keyword(code).integer(count); }

  GmfBuilder& word(std::int32_t value) { return put(value); }
  GmfBuilder& integer(std::int64_t value) { return version_ == 4 ? put(value) : put(static_cast<std::int32_t>(value)); }
  GmfBuilder& integers(const std::vector<std::int64_t>& values) {
    for (const std::int64_t value : values) integer(value);
    return *this;
  }
  GmfBuilder& real(double value) { return version_ == 1 ? put(static_cast<float>(value)) : put(value); }
  GmfBuilder& reals(const std::vector<double>& values) {
    for (const double value : values) real(value);
    return *this;
  }
  /// Replaces the position behind the head that was written last.
  GmfBuilder& next(std::int64_t value) {
    std::string tail = bytes_.substr(pending_ + position_size());
    bytes_.resize(pending_);
    position(value);
    bytes_ += tail;
    pending_ = 0;
    return *this;
  }

  [[nodiscard]] std::string end() {
    link();
    word(54);
    position(0);
    return bytes_;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
  [[nodiscard]] std::size_t position_size() const { return version_ >= 3 ? 8 : 4; }

  GmfBuilder& position(std::int64_t value) {
    return version_ >= 3 ? put(value) : put(static_cast<std::int32_t>(value));
  }
  void link() {
    if (pending_ != 0) next(static_cast<std::int64_t>(bytes_.size()));
  }

  template <class T>
  GmfBuilder& put(T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes_.append(raw.begin(), raw.end());
    return *this;
  }

  int version_;
  std::endian order_;
  std::string bytes_;
  std::size_t pending_ = 0;  ///< where the position of the next keyword is missing
};

inline Mesh text_mesh(const std::string& content) {
  return gmf::read_mesh(gmf::parse("wing.mesh", gmf::copy_of(content)));
}
inline Mesh binary_mesh(const std::string& content) {
  return gmf::read_mesh(gmf::parse("wing.meshb", gmf::copy_of(content)));
}

inline gmf::GmfFile text_file(const std::string& content) {
  return gmf::parse("wing.sol", gmf::copy_of(content));
}
inline gmf::GmfFile binary_file(const std::string& content) {
  return gmf::parse("wing.solb", gmf::copy_of(content));
}

/// The message with which `call` throws an Error; "nothing thrown" if it returns.
template <class Error, class Call>
std::string message_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing thrown";
}

/// Two tetrahedra on five points, with every kind of entity, and references that differ.
inline Mesh two_tets() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 1e-300, -1.0 / 3}};
  mesh.point_refs = {1, -2, 3, 2147483647, 0};
  mesh.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.tetrahedron_refs = {7, 8};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}, {0, 3, 1}};
  mesh.triangle_refs = {4, 5, 6};
  mesh.edges = {{0, 1}, {3, 4}};
  mesh.edge_refs = {9, 10};
  mesh.corners = {0, 4};
  mesh.required_points = {1, 1};
  mesh.ridges = {1};
  mesh.required_edges = {0, 1};
  mesh.required_triangles = {2};
  mesh.required_tetrahedra = {1};
  return mesh;
}

/// A directory of its own for each test, removed at the end.
class InDirectory : public testing::Test {
protected:
  InDirectory() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    directory = std::filesystem::path(testing::TempDir()) /
                (std::string("taut-") + info->test_suite_name() + "-" + info->name());
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
  }
  ~InDirectory() override { std::filesystem::remove_all(directory); }

  [[nodiscard]] std::size_t files() const {
    using Iterator = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Iterator(directory), Iterator()));
  }

  std::filesystem::path directory;
};

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void save(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

}  // namespace taut::test
