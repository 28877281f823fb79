#pragma once

// The sign of a 2D determinant, decided exactly.

namespace geom {

// The sign (-1, 0, 1) of (bx - ax)(cy - ay) - (by - ay)(cx - ax) for the doubles given, exact.
int orientation(double ax, double ay, double bx, double by, double cx, double cy);

// The same by exact arithmetic alone: the slow path (cgal_orientation.cpp).
int exact_orientation(double ax, double ay, double bx, double by, double cx, double cy);

}  // namespace geom
