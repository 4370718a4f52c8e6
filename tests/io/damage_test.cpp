// Damaged files: whatever the bytes, a reader returns or throws InputError.
#include <random>

#include "io/gmf_builder.hpp"

namespace taut::test {
namespace {

using Sample = std::string;

const std::vector<Sample> samples = {"two_tets.mesh", "two_tets.meshb", "two_tets.sol", "two_tets.solb"};

/// Whether the content is read; any exception except InputError ends the test.
bool is_read(const Sample& sample, const std::string& content) {
  try {
    const gmf::GmfFile file = gmf::parse(sample, gmf::copy_of(content));
    if (sample.find(".sol") != std::string_view::npos) {
      (void)gmf::read_metric(file);
    } else {
      (void)gmf::read_mesh(file);
    }
    return true;
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with(sample)) << error.what();
    return false;
  }
}

class Damaged : public testing::TestWithParam<Sample> {
protected:
  std::string content = content_of(std::filesystem::path(TAUT_TEST_DATA) / GetParam());
};

TEST_P(Damaged, TruncatedAnywhere) {
  ASSERT_TRUE(is_read(GetParam(), content));
  std::size_t read = 0;
  for (std::size_t size = 0; size < content.size(); ++size) read += is_read(GetParam(), content.substr(0, size));
  // A text without its last lines may still be complete, and so may a binary file without its last keywords.
  EXPECT_LT(read, content.size() / 4);
}

TEST_P(Damaged, ByBytesChanged) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20000; ++trial) {
    std::string damaged = content;
    for (int change = 0; change <= trial % 4; ++change) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    (void)is_read(GetParam(), damaged);
  }
}

TEST_P(Damaged, ByBytesLostOrDoubled) {
  for (std::size_t at = 0; at < content.size(); ++at) {
    (void)is_read(GetParam(), std::string(content).erase(at, 1 + at % 9));
    (void)is_read(GetParam(), std::string(content).insert(at, content.substr(at, 1 + at % 9)));
  }
}

INSTANTIATE_TEST_SUITE_P(Gmf, Damaged, testing::ValuesIn(samples), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

}  // namespace
}  // namespace taut::test
