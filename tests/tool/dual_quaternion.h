/* An independent reference for poses: dual quaternions in double, nothing of the library.
 *
 * A motor is the dual quaternion r + ε d with r = (s; b23, -b13, b12) and d = (-w; b1∞, b2∞, b3∞). That map is
 * linear, so a blend of motors is the same blend of dual quaternions, and it takes the paper's product UV, in which U
 * acts first, to the product of quaternions v u. */
#ifndef MOTORWAY_TESTS_DUAL_QUATERNION_H
#define MOTORWAY_TESTS_DUAL_QUATERNION_H

#include <array>
#include <functional>
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

/* The same pose with |r| = 1 and r · d = 0. */
DualQuaternion reference_normalized(const DualQuaternion &pose);

/* The screw from one pose to another, the shortest way, by sine and arc tangent. */
DualQuaternion reference_slerp(const DualQuaternion &from, const DualQuaternion &to, double t);

/* The other schemes, over the paper's knots: the tableau of de Boor (of a Bézier motion: de Casteljau) with slerp;
 * relative motions, each to the power of a sum of basis functions; blended logarithms relative to a base pose, and
 * the same along parabolas through the logarithms of three keys at a time, neighbouring ones faded into each other.
 */
DualQuaternion reference_multiplicative(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                        unsigned degree, double t);
DualQuaternion reference_cumulative(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                    unsigned degree, double t);
DualQuaternion reference_generator(const std::vector<DualQuaternion> &controls, const std::vector<double> &knots,
                                   unsigned degree, const DualQuaternion &base, double t);
DualQuaternion reference_generator_keys(const std::vector<DualQuaternion> &keys, const std::vector<double> &times,
                                        const DualQuaternion &base, double t);

Vector reference_translation_of(const DualQuaternion &pose);
Vector reference_point(const DualQuaternion &pose, const Vector &point);
Vector reference_direction(const DualQuaternion &pose, const Vector &direction);

/* The angular velocity of a motion and the velocity of the origin of its body, by differences. */
struct Velocity {
    Vector angular, linear;
};
Velocity reference_velocity(const std::function<DualQuaternion(double)> &motion, double t, double step);

/* The control poses of the paper's figure 5, from its formulas. */
std::vector<DualQuaternion> figure_5_controls();

} // namespace motorway::tool

#endif
