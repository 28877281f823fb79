#pragma once

// The arithmetic of doubles that all code of Skyway assumes, in a program that may have changed it.
//
// Example:
//   std::fesetround(FE_UPWARD);
//   {
//     const geom::UsualArithmetic usual;
//     assert(std::fegetround() == FE_TONEAREST);
//   }
//   assert(std::fegetround() == FE_UPWARD);
//   std::fesetround(FE_TONEAREST);

#include <cfenv>

namespace geom {

// While it lives, this thread rounds to nearest, keeps numbers below 2^-1022, and traps nothing;
// then all is as it was. A host program may have set another rounding, and a library built with
// -ffast-math drops small numbers in all threads that begin after it was loaded. Threads that begin
// meanwhile have the usual arithmetic, too.
class UsualArithmetic {
 public:
  UsualArithmetic();
  ~UsualArithmetic();
  UsualArithmetic(const UsualArithmetic&) = delete;
  UsualArithmetic& operator=(const UsualArithmetic&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace geom
