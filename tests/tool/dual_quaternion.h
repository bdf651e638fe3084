/* An independent reference for poses: dual quaternions in double, nothing of the library.
 *
 * A motor is the dual quaternion r + ε d with r = (s; b23, -b13, b12) and d = (-w; b1∞, b2∞, b3∞). That map is
 * linear, so a blend of motors is the same blend of dual quaternions, and it takes the paper's product UV, in which U
 * acts first, to the product of quaternions v u. */
#ifndef MOTORWAY_TESTS_DUAL_QUATERNION_H
#define MOTORWAY_TESTS_DUAL_QUATERNION_H

#include <array>
#include <vector>

namespace motorway::tool {

using Quaternion = std::array<double, 4>; /* w x y z */
using Vector = std::array<double, 3>;

struct DualQuaternion {
    Quaternion real, dual;
};

DualQuaternion reference_rotation(const Vector &axis, double degrees, const Vector &through = {0, 0, 0});
DualQuaternion reference_translation(const Vector &offset);
DualQuaternion reference_sequence(const std::vector<DualQuaternion> &steps); /* the first acts first */

/* The eight coefficients s b12 b13 b23 b1∞ b2∞ b3∞ w. */
std::array<double, 8> coefficients(const DualQuaternion &pose);

/* Σ N_i(t) S_i with the basis functions by the recursion of Cox and de Boor, over the paper's knots. */
DualQuaternion reference_bspline(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                 unsigned degree, double t);

Vector reference_point(const DualQuaternion &pose, const Vector &point);
Vector reference_direction(const DualQuaternion &pose, const Vector &direction);

/* The control poses of the paper's figure 5, from its formulas. */
std::vector<DualQuaternion> figure_5_controls();

} // namespace motorway::tool

#endif
