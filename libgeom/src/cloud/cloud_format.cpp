#include "geom/cloud/cloud_format.h"

namespace geom {
namespace {

constexpr const CloudFormat* kTable[] = {&kPcdCloud, &kPlyCloud, &kLasCloud, &kXyzCloud};

}  // namespace

FormatRows<CloudFormat> cloud_formats() { return kTable; }

}  // namespace geom
