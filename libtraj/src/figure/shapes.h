#pragma once

// The names of libgeom's room of figures that this one uses as its own.

#include "geom/figure/figure.h"
#include "geom/figure/histogram.h"
#include "geom/figure/palette.h"
#include "geom/figure/svg.h"

namespace traj::figure {

using geom::figure::Figure;
using geom::figure::Frame;
using geom::figure::Histogram;
using geom::figure::Level;
using geom::figure::Panel;
using geom::figure::Point;
using geom::figure::Series;
using geom::figure::Span;
using geom::figure::Svg;

using geom::figure::colour;
using geom::figure::drawn;
using geom::figure::histogram;
using geom::figure::kInk;
using geom::figure::kLimit;
using geom::figure::kWarning;
using geom::figure::text_width;

}  // namespace traj::figure
