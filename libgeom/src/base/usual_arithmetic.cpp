#include "geom/base/usual_arithmetic.h"

namespace geom {

UsualArithmetic::UsualArithmetic() {
  std::fegetenv(&before_);
  std::fesetenv(FE_DFL_ENV);
}

UsualArithmetic::~UsualArithmetic() { std::fesetenv(&before_); }

}  // namespace geom
