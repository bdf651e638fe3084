// The motor of the rotation that is nearest to a matrix, for matrices that are none themselves.
#pragma once

namespace motorway {

// The rotation R for which the sum of the squares of matrix - R is smallest, then the translation; s >= 0. Of a matrix
// with a number that is not finite the motor is not finite either.
void nearest_motor(const double (&matrix)[3][3], const double (&translation)[3], double (&motor)[8]);

} // namespace motorway
