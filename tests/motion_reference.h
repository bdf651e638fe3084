// Motions by their definitions, to judge the library's: poses are dual quaternions of long double, exponentials and
// logarithms call the mathematical library, and a spline is its blossom, one weighted mean after the other.
#ifndef MOTORWAY_TESTS_MOTION_REFERENCE_H
#define MOTORWAY_TESTS_MOTION_REFERENCE_H

#include <array>
#include <cstddef>
#include <vector>

#include "motorway_views.h"
#include "reference.h"

namespace motorway::reference {

using Quaternion = std::array<long double, 4>;  // x y z w

// r + εd with d = ½ t r: a pose, or a multiple of one by a dual number. If both have no w, a generator or a twist.
struct DualQuaternion {
    Quaternion real{0, 0, 0, 1}, dual{0, 0, 0, 0};
};

DualQuaternion operator+(const DualQuaternion &a, const DualQuaternion &b);
DualQuaternion operator*(long double factor, const DualQuaternion &a);
DualQuaternion operator*(const DualQuaternion &a, const DualQuaternion &b);  // b acts first

DualQuaternion compose(const DualQuaternion &first, const DualQuaternion &then);
DualQuaternion inverse(const DualQuaternion &a);
DualQuaternion normalize(const DualQuaternion &a);
long double dot_of_rotations(const DualQuaternion &a, const DualQuaternion &b);  // negative: the long way apart

DualQuaternion exp(const DualQuaternion &generator);
DualQuaternion log(const DualQuaternion &unit);  // of itself, not of the nearer of ±
DualQuaternion slerp(const DualQuaternion &first, const DualQuaternion &second, long double t);  // the short way

// Where a pose takes a point.
std::array<long double, 3> apply_point(const DualQuaternion &pose, const std::array<long double, 3> &point);

// The eight numbers of a motor, and the six of a bivector.
DualQuaternion dual_quaternion(const std::array<long double, 8> &motor);
std::array<long double, 8> motor_numbers(const DualQuaternion &a);
std::array<long double, 6> bivector_numbers(const DualQuaternion &a);

// What mw_motion_f32 says, in exact numbers.
struct MotionDescription {
    mw_motion_kind kind = MW_MOTION_ADDITIVE;
    std::size_t degree = 1;
    std::vector<DualQuaternion> controls;
    std::vector<long double> knots, weights;
    bool closed = false;
    DualQuaternion base;
    bool keeps_signs = false;
};

class Motion {
public:
    explicit Motion(const MotionDescription &description);

    long double first() const { return knots_[first_span_]; }
    long double last() const { return knots_[last_span_ + 1]; }

    // The pieces of the motion between knots that are not equal.
    std::vector<std::size_t> spans() const;
    std::size_t span_of(long double t) const;  // that to the right of a knot
    long double span_begin(std::size_t span) const { return knots_[span]; }
    long double span_end(std::size_t span) const { return knots_[span + 1]; }

    // Each piece goes on beyond its knots.
    DualQuaternion at(long double t, std::size_t span) const;
    DualQuaternion at(long double t) const { return at(t, span_of(t)); }

    // S^-1 S' of the motion normalised, or S' S^-1, by differences of the eighth order.
    enum class Frame { space, body };
    DualQuaternion twist(long double t, std::size_t span, Frame frame = Frame::space) const;

    // The controls that make up a piece, weighted and of the sign that they are taken with.
    std::vector<DualQuaternion> controls_of(std::size_t span) const;

private:
    void choose_signs(const MotionDescription &description);
    void repeat(std::size_t before, std::size_t after, std::size_t knots_before, std::size_t knots_after);

    DualQuaternion sum_of_controls(long double t, std::size_t span) const;
    DualQuaternion cumulative(long double t, std::size_t span) const;
    DualQuaternion hermite(long double t, std::size_t span) const;
    DualQuaternion derivative_at_key(std::size_t key) const;

    mw_motion_kind kind_;
    std::size_t degree_, first_span_ = 0, last_span_ = 0;
    long double return_sign_ = 1;           // of the first control when a closed motion comes back to it
    std::vector<DualQuaternion> controls_;  // of generators their logarithms
    std::vector<long double> knots_;
    DualQuaternion base_;
};

// 0, 1, 2, ...: what a motion without knots has.
std::vector<long double> default_knots(mw_motion_kind kind, std::size_t degree, std::size_t control_count,
                                       bool closed);

}  // namespace motorway::reference

#endif
