// Motions to test: a description that owns its arrays, a compiled one that owns its memory, samples as arrays of
// numbers, and random motions of every kind.
#ifndef MOTORWAY_TESTS_MOTION_TESTER_H
#define MOTORWAY_TESTS_MOTION_TESTER_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "isas.h"
#include "motion_reference.h"
#include "motors.h"
#include "precisions.h"
#include "subject.h"

namespace motorway::testing {

constexpr mw_motion_kind all_motion_kinds[] = {MW_MOTION_ADDITIVE, MW_MOTION_MULTIPLICATIVE, MW_MOTION_CUMULATIVE,
                                               MW_MOTION_GENERATOR, MW_MOTION_GENERATOR_KEYS};

inline const char *name_of(mw_motion_kind kind)
{
    static const char *const names[] = {"none", "additive", "multiplicative", "cumulative", "generator",
                                        "generator_keys"};
    return names[kind];
}

inline bool is_additive(mw_motion_kind kind) { return kind == MW_MOTION_ADDITIVE; }
inline bool is_of_keys(mw_motion_kind kind) { return kind == MW_MOTION_GENERATOR_KEYS; }

template <class T>
reference::DualQuaternion exact_pose(const T *motor)
{
    std::array<long double, 8> numbers;
    std::copy_n(motor, 8, numbers.begin());
    return reference::dual_quaternion(numbers);
}

template <class T>
typename api<T>::motor rounded_pose(const reference::DualQuaternion &pose)
{
    typename api<T>::motor motor;
    const auto numbers = reference::motor_numbers(pose);
    std::transform(numbers.begin(), numbers.end(), &motor.s, [](long double x) { return static_cast<T>(x); });
    return motor;
}

template <class T>
struct MotionData {
    mw_motion_kind kind = MW_MOTION_ADDITIVE;
    std::size_t degree = 1;
    std::vector<typename api<T>::motor> controls;  // of all motions
    std::vector<T> knots, weights;
    bool closed = false;
    std::vector<typename api<T>::motor> base;  // one or none
    std::size_t motion_count = 1;

    std::size_t control_count() const { return controls.size() / motion_count; }

    typename api<T>::motion view() const
    {
        typename api<T>::motion motion{};
        motion.kind = kind;
        motion.degree = static_cast<unsigned>(degree);
        motion.controls = controls.data();
        motion.control_count = control_count();
        motion.knots = knots.empty() ? nullptr : knots.data();
        motion.knot_count = knots.size();
        motion.weights = weights.empty() ? nullptr : weights.data();
        motion.closed = closed;
        motion.base = base.empty() ? nullptr : base.data();
        motion.motion_count = motion_count;
        return motion;
    }

    // One of the motions.
    reference::Motion exact(std::size_t index = 0, unsigned flags = MW_DEFAULT) const
    {
        reference::MotionDescription description;
        description.kind = kind;
        description.degree = degree;
        for (std::size_t k = 0; k < control_count(); ++k)
            description.controls.push_back(exact_pose(&controls[index * control_count() + k].s));
        description.knots.assign(knots.begin(), knots.end());
        description.weights.assign(weights.begin(), weights.end());
        description.closed = closed;
        if (!base.empty())
            description.base = exact_pose(&base[0].s);
        description.keeps_signs = (flags & MW_KEEP_SIGNS) != 0;
        return reference::Motion(description);
    }

    std::string name() const
    {
        return std::string(name_of(kind)) + " " + api<T>::name + ", degree " + std::to_string(degree) + ", " +
               std::to_string(control_count()) + " controls" + (knots.empty() ? "" : ", knots") +
               (weights.empty() ? "" : ", weights") + (closed ? ", closed" : "");
    }
};

template <class T>
class CompiledMotion {
public:
    explicit CompiledMotion(const MotionData<T> &data, unsigned flags = MW_DEFAULT)
    {
        const auto motion = data.view();
        std::size_t size = 0, where = 0;
        EXPECT_EQ(api<T>::motion_size(&size, &motion, &where), MW_OK) << data.name();
        memory_.resize((size + 7) / 8);
        const mw_status status = api<T>::compile_motion(&motion_, memory_.data(), size, &motion, flags, &where);
        EXPECT_EQ(status, MW_OK) << data.name() << ": " << mw_status_text(status) << " (" << where << ")";
        size_ = size;
    }
    CompiledMotion(const CompiledMotion &) = delete;

    const typename api<T>::compiled_motion *get() const { return motion_; }
    std::size_t size() const { return size_; }

    T first() const { return domain(0); }
    T last() const { return domain(1); }

private:
    T domain(int end) const
    {
        T domain[2] = {};
        EXPECT_EQ(api<T>::motion_domain(domain, motion_), MW_OK);
        return domain[end];
    }

    std::vector<std::uint64_t> memory_;
    std::size_t size_ = 0;
    const typename api<T>::compiled_motion *motion_ = nullptr;
};

template <class T>
typename api<T>::motors packed_motors(T *numbers)
{
    return api<T>::motors_aos(reinterpret_cast<typename api<T>::motor *>(numbers), sizeof(T[8]));
}

template <class T>
typename api<T>::bivectors packed_bivectors(T *b)
{
    return {b, b + 1, b + 2, b + 3, b + 4, b + 5, sizeof(T[6])};
}

// Eight numbers a parameter.
template <class T>
std::vector<T> sampled(const CompiledMotion<T> &motion, const std::vector<T> &parameters, unsigned flags = MW_DEFAULT,
                       std::size_t index = 0)
{
    std::vector<T> out(8 * parameters.size());
    const mw_status status = api<T>::sample_motion_one(packed_motors(out.data()), motion.get(), index,
                                                       parameters.data(), parameters.size(), flags);
    EXPECT_EQ(status, MW_OK) << mw_status_text(status);
    return out;
}

template <class T>
struct Twists {
    std::vector<T> poses, twists;  // eight and six numbers a parameter
};

template <class T>
Twists<T> twisted(const CompiledMotion<T> &motion, const std::vector<T> &parameters, unsigned flags = MW_DEFAULT,
                  std::size_t index = 0)
{
    Twists<T> out{std::vector<T>(8 * parameters.size()), std::vector<T>(6 * parameters.size())};
    const mw_status status = api<T>::sample_motion_twist_one(
        packed_motors(out.poses.data()), packed_bivectors(out.twists.data()), motion.get(), index, parameters.data(),
        parameters.size(), flags);
    EXPECT_EQ(status, MW_OK) << mw_status_text(status);
    return out;
}

// ------------------------------------------------------------------------------------------------------ random poses

// Turns by no more than `turn`, and then moves by no more than `reach` in each direction.
inline reference::DualQuaternion random_displacement(Random &random, double turn, double reach)
{
    const reference::Vector3 axis = random_unit_vector(random);
    const double angle = random.uniform(0, turn);
    reference::DualQuaternion rotation, translation;
    for (std::size_t k = 0; k < 3; ++k) {
        rotation.real[k] = std::sin(angle / 2) * static_cast<long double>(axis[k]);
        translation.dual[k] = random.uniform(-reach / 2, reach / 2);
    }
    rotation.real[3] = std::cos(angle / 2);
    return compose(normalize(rotation), translation);
}

// Neighbours are less than 1.3 radians apart, so that every short way is one by far; of generators all are as near to
// the base. Additive motions take any multiple of a pose, and also one by a dual number.
template <class T>
void draw_controls(Random &random, MotionData<T> &data, std::size_t control_count)
{
    using reference::DualQuaternion;
    const bool of_generators = data.kind == MW_MOTION_GENERATOR || is_of_keys(data.kind);
    data.controls.clear();
    for (std::size_t m = 0; m < data.motion_count; ++m) {
        DualQuaternion pose = random_displacement(random, 3, 4);
        if (of_generators)
            pose = data.base.empty() ? DualQuaternion() : exact_pose(&data.base[0].s);
        const DualQuaternion base = pose;
        for (std::size_t k = 0; k < control_count; ++k) {
            pose = compose(of_generators ? base : pose, random_displacement(random, 1.3, 3));
            DualQuaternion control = pose;
            if (is_additive(data.kind) && random.chance(3)) {
                const DualQuaternion dual_number{{0, 0, 0, 1}, {0, 0, 0, random.uniform(-1, 1)}};
                control = static_cast<long double>(random.uniform(0.5, 2)) * compose(pose, dual_number);
            }
            data.controls.push_back(rounded_pose<T>(control));
        }
    }
}

// Multiples of 1/16, exact in both precisions. At the ends of an open motion, unless they are clamped, and inside
// knots are repeated at random, `most` times at most.
enum class Ends { free, clamped };

template <class T>
void draw_knots(Random &random, MotionData<T> &data, Ends ends, std::size_t most)
{
    const std::size_t controls = data.control_count(), degree = is_of_keys(data.kind) ? 1 : data.degree;
    const std::size_t count = data.closed ? controls + 1 : controls + degree - 1;
    const bool clamped = ends == Ends::clamped && !data.closed && !is_of_keys(data.kind);
    T knot = std::floor(static_cast<T>(random.uniform(-64, 64)) * 16) / 16;
    std::size_t repeated = 1;
    data.knots.clear();
    for (std::size_t k = 0; k < count; ++k) {
        const bool at_end = clamped && ((k > 0 && k < degree) || k > controls - 1);
        const bool rises = k == controls - 1 || k + 1 == count || (clamped && k == degree) || is_of_keys(data.kind);
        const bool repeats = at_end || (!rises && k > 0 && repeated < most && random.chance(3));
        if (k > 0 && !repeats)
            knot += static_cast<T>(1 + random.below(64)) / 16;
        repeated = repeats ? repeated + 1 : 1;
        data.knots.push_back(knot);
    }
}

template <class T>
MotionData<T> random_motion(Random &random, mw_motion_kind kind, std::size_t degree, std::size_t control_count,
                            bool closed = false)
{
    MotionData<T> data;
    data.kind = kind;
    data.degree = degree;
    data.closed = closed;
    if ((kind == MW_MOTION_GENERATOR || is_of_keys(kind)) && random.chance(2))
        data.base = {rounded_pose<T>(random_displacement(random, 3, 4))};
    draw_controls(random, data, control_count);
    return data;
}

// Both ends, all knots inside and what is next to each, and `count` others, in no order.
template <class T>
std::vector<T> parameters_of(Random &random, const reference::Motion &motion, std::size_t count)
{
    const T first = static_cast<T>(motion.first()), last = static_cast<T>(motion.last());
    std::vector<T> parameters = {first, last, std::nextafter(last, first), std::nextafter(first, last)};
    for (std::size_t span : motion.spans())
        if (motion.first() < motion.span_begin(span)) {
            parameters.push_back(static_cast<T>(motion.span_begin(span)));
            parameters.push_back(std::nextafter(parameters.back(), first));
        }
    for (std::size_t k = 0; k < count; ++k) {
        const double t = random.uniform(static_cast<double>(first), static_cast<double>(last));
        parameters.push_back(std::clamp(static_cast<T>(t), first, last));
    }
    for (std::size_t k = parameters.size(); k > 1; --k)
        std::swap(parameters[k - 1], parameters[random.below(k)]);
    return parameters;
}

// --------------------------------------------------------------------------------------------------------- distances

template <class T>
bool same_bits(const std::vector<T> &a, const std::vector<T> &b)
{
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

// In epsilons: the largest difference of two motors, of which the sign does not count, with lengths of the order of
// `reach`.
template <class T>
long double motor_error(const reference::DualQuaternion &motor, const reference::DualQuaternion &exact,
                        long double reach = 1)
{
    const long double sign = dot_of_rotations(motor, exact) < 0 ? -1 : 1;
    const auto numbers = motor_numbers(motor), expected = motor_numbers(sign * exact);
    long double error = 0;
    for (std::size_t k = 0; k < 8; ++k)
        error = std::max(error, std::abs(numbers[k] - expected[k]) / (k < 4 ? 1 : reach));
    return error / epsilon<T>;
}

template <class T>
long double motor_error(const T *motor, const reference::DualQuaternion &exact, long double reach = 1)
{
    return motor_error<T>(exact_pose(motor), exact, reach);
}

// The same of the poses that they are, whatever their length.
template <class T>
long double pose_error(const T *motor, const reference::DualQuaternion &exact, long double reach = 1)
{
    return motor_error<T>(normalize(exact_pose(motor)), normalize(exact), reach);
}

// The largest length in the second half of the controls and the base, or 1.
template <class T>
long double reach_of(const MotionData<T> &data)
{
    long double reach = 1;
    for (const auto *poses : {&data.controls, &data.base})
        for (const auto &pose : *poses)
            reach = std::max(reach, std::hypot(std::hypot(static_cast<long double>(pose.b1i), pose.b2i), pose.b3i));
    return reach;
}

// Where the times of keys are uneven their spline swings out, by a third of the quotient of two intervals: it keeps
// the slope of a short interval over a long one. Rounding of the parameter counts as much more.
inline long double swing_of(const reference::Motion &keys)
{
    long double least = keys.last() - keys.first(), most = 0;
    for (std::size_t span : keys.spans()) {
        least = std::min(least, keys.span_end(span) - keys.span_begin(span));
        most = std::max(most, keys.span_end(span) - keys.span_begin(span));
    }
    return most / least / 3;
}

// Parameters from 0 to 1, equally far apart.
template <class T>
std::vector<T> unit_interval(std::size_t count)
{
    std::vector<T> parameters;
    for (std::size_t i = 0; i < count; ++i)
        parameters.push_back(static_cast<T>(i) / static_cast<T>(count - 1));
    return parameters;
}

}  // namespace motorway::testing

#endif
