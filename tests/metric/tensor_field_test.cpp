// Between tensors and the numbers of a field.
#include <gtest/gtest.h>

#include "base/with_threads.hpp"
#include "taut/field.hpp"

namespace taut {
namespace {

using test::refusal;

const Tensors two_tensors = {{1, 2, 3, 4, 5, 6}, {7, 8, 9, 10, 11, 12}};

TEST(TensorField, HoldsTheTensorsOneAfterTheOther) {
  const Field field = field_of(two_tensors);
  EXPECT_EQ(field.kind, Field::Kind::tensor);
  EXPECT_EQ(field.values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(field.component(3), (std::vector<double>{4, 10}));
}

TEST(TensorField, GivesTheTensorsBack) {
  EXPECT_EQ(tensors_of(field_of(two_tensors)), two_tensors);
  EXPECT_EQ(tensors_of(field_of({})), Tensors{});
}

TEST(TensorField, RefusesWhatIsNone) {
  const auto message = [](const Field& field) { return refusal(1, [&] { return tensors_of(field); }); };
  EXPECT_EQ(message({Field::Kind::vector, {1, 2, 3}}),
            "field: 3 numbers per vertex found, expected a tensor, which has six");
  EXPECT_EQ(message({Field::Kind::tensor, {1, 2, 3, 4, 5, 6, 7}}), "field: 7 numbers found, expected six per vertex");
}

}  // namespace
}  // namespace taut
