#include "interval/arithmetic.h"

#include <gtest/gtest.h>
#include <string>

#include "base/error.h"

namespace gcslab {
namespace {

TEST(Arithmetics, HaveNamesThatReadBack) {
  for (const Arithmetic arithmetic : kArithmetics) {
    EXPECT_EQ(arithmetic_from_name(name_of(arithmetic)), arithmetic);
    EXPECT_FALSE(description_of(arithmetic).empty());
  }
}

TEST(Arithmetics, AMisspeltNameIsRefusedWithTheNearest) {
  try {
    arithmetic_from_name("bost");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("'boost'"), std::string::npos) << error.what();
  }
}

TEST(Arithmetics, OnlyUnroundedIsABaseline) {
  for (const Arithmetic arithmetic : kArithmetics) {
    EXPECT_EQ(promise_of(arithmetic) == Promise::baseline, arithmetic == Arithmetic::unrounded);
  }
}

TEST(Arithmetics, NameTheirNumberType) {
  const auto third = [](Arithmetic arithmetic) {
    return with_arithmetic(arithmetic, []<class T>(std::type_identity<T>) {
      const typename NumberTraits<T>::Scope scope;
      return NumberTraits<T>::enclosure(NumberTraits<T>::from_interval(1) /
                                        NumberTraits<T>::from_interval(3));
    });
  };
  EXPECT_EQ(third(Arithmetic::fast), third(Arithmetic::boost));
  EXPECT_EQ(third(Arithmetic::fast), third(Arithmetic::mpfr));
  EXPECT_TRUE(is_singleton(third(Arithmetic::unrounded)));
}

}  // namespace
}  // namespace gcslab
