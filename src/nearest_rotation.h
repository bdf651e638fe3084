// The motor of the rotation that is nearest to a matrix, for matrices that are none themselves. Scalar, in double.
#pragma once

namespace motorway {

// The rotation R for which the sum of the squares of matrix - R is smallest, then the translation; s >= 0. All numbers
// are finite. False if no rotation is nearest, because others are as near, to the tolerance: with the singular values
// a >= b >= c of the matrix, where b + c, or b - c if it reflects, is about that times a or less. So it is of a mirror
// image, and of what leaves no more than a line of space.
bool nearest_motor(const double (&matrix)[3][3], const double (&translation)[3], double tolerance, double (&motor)[8]);

} // namespace motorway
