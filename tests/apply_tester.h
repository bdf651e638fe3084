// The subjects apply <operand> <pairing> of every operand: under one motor, a motor each, a motor of a palette, and
// as a grid of one row (grid_test.cpp has the others). In mixed precision M, of the motors, is double and T float.
#ifndef MOTORWAY_TESTS_APPLY_TESTER_H
#define MOTORWAY_TESTS_APPLY_TESTER_H

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "apply_api.h"
#include "apply_expected.h"
#include "guarded_buffer.h"
#include "index_array.h"
#include "motors.h"
#include "subject.h"

namespace motorway::testing {

// An element of one operand; the exact results are for all numbers that can be.
template <class T>
void draw_operand(Random &random, Moved moved, T *components)
{
    draw_vector(random, components);
    const T *p = components;
    switch (moved) {
    case Moved::point:
    case Moved::direction: break;
    case Moved::tangent: components[3] = static_cast<T>(random.chance(2) ? 1 : random.uniform(-2, 2)); break;
    case Moved::vertex: draw_vector(random, components + 3); break;
    case Moved::vector: {
        const T weight = static_cast<T>(random.chance(3) ? 0 : random.chance(2) ? 1 : random.uniform(-3, 3));
        const T half_square = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2;  // that of a point
        const T rest = static_cast<T>(random.chance(2) ? 0 : random.uniform(-4, 4));
        std::copy_backward(components, components + 3, components + 4);
        components[0] = weight;
        components[4] = weight * half_square + rest;
        break;
    }
    case Moved::line: {
        draw_vector(random, components + 3);
        if (random.chance(3))
            break;  // six numbers of any kind are a screw
        const T q[3] = {p[3], p[4], p[5]};
        for (int i = 0; i < 3; ++i)
            components[3 + i] = q[(i + 1) % 3] * p[(i + 2) % 3] - q[(i + 2) % 3] * p[(i + 1) % 3];
        break;
    }
    case Moved::motor: draw_motor(random, any_regime(random), components); break;
    case Moved::bivector:
        draw_vector(random, components + 3);
        if (random.chance(6))
            std::fill_n(components, 3, T(0));  // that of a translation
        break;
    }
}

// Motors lie among the inputs as bytes: in mixed precision they are doubles among floats.
template <class M, class T>
std::array<M, 8> motor_among(const T *input)
{
    std::array<M, 8> motor;
    std::memcpy(motor.data(), input, sizeof motor);
    return motor;
}

// What all of these subjects have in common.
template <class T, class M>
class Applied : public Subject<T> {
public:
    static constexpr bool mixed = !std::is_same_v<T, M>;

    Applied(Moved moved, Pairing pairing, Motors motors)
        : functions_(apply_functions_of<T>(moved, mixed)), pairing_(pairing), motors_(motors),
          flags_(motors == Motors::unit ? MW_UNIT_MOTORS : MW_DEFAULT)
    {
        if constexpr (mixed)
            shift_ = {{1000.125, -3e6, 0.1}, {-1e-3, 3e6 + 1.0 / 3, 7}};
    }

    std::string name() const override
    {
        return functions_.name(pairing_) + (flags_ ? " with flags " + std::to_string(flags_) : "");
    }

    void add_flags(unsigned flags) override { flags_ |= flags; }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{functions_.views, functions_.components()}};
    }

    Operand output() const override { return functions_.views; }

protected:
    Moved moved() const { return functions_.moved; }
    const mw_shift *shift() const { return mixed ? &shift_ : nullptr; }

    ApplyCall<T> call(const View<T> &out, const View<T> &in, std::size_t count) const
    {
        ApplyCall<T> arguments;
        arguments.out = out;
        arguments.in = in;
        arguments.count = count;
        arguments.shift = shift();
        arguments.flags = flags_;
        return arguments;
    }

    mw_status apply(const ApplyCall<T> &arguments) const { return functions_.run(pairing_, arguments); }

    Expected expect_applied(const M *motor, const T *element) const
    {
        return expect_moved(motor, element, moved(), motors_, shift());
    }

private:
    ApplyFunctions<T> functions_;
    Pairing pairing_;
    Motors motors_;
    unsigned flags_;
    mw_shift shift_{};
};

// Under one motor, or a grid with a single row. The motor itself lies against a forbidden page too.
template <class T, class M>
class AppliedOne : public Applied<T, M> {
public:
    AppliedOne(Moved moved, Pairing pairing, const M *motor, Guard guard)
        : Applied<T, M>(moved, pairing, Motors::any), is_grid_(pairing == Pairing::grid)
    {
        std::copy_n(motor, 8, motor_);
        placed_ = guarded_.place_copy(motor_, 8, guard);
    }

    bool keeps_apart() const override { return is_grid_; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        ApplyCall<T> arguments = this->call(out, inputs[0], count);
        arguments.motor = placed_;
        for (std::size_t c = 0; c < 8; ++c)
            arguments.motors.component.push_back(reinterpret_cast<T *>(placed_ + c));
        arguments.motors.stride = sizeof(M[8]);
        arguments.motor_count = 1;
        arguments.row_stride = count * out.stride;
        return this->apply(arguments);
    }

    void draw(Random &random, T *const *inputs) const override { draw_operand(random, this->moved(), inputs[0]); }
    Expected expect(const T *const *inputs) const override { return this->expect_applied(motor_, inputs[0]); }

    static Subjects<T> all(Moved moved, Pairing pairing)
    {
        Subjects<T> subjects;
        Random random(1);
        for (int regime = 0; regime < static_cast<int>(Regime::count); ++regime) {
            M motor[8];
            draw_motor(random, static_cast<Regime>(regime), motor);
            const Guard guard = regime % 2 ? Guard::before : Guard::after;
            subjects.push_back(std::make_unique<AppliedOne>(moved, pairing, motor, guard));
        }
        return subjects;
    }

private:
    bool is_grid_;
    M motor_[8];
    GuardedBuffer guarded_{sizeof(M[8])};
    M *placed_;
};

template <class T, class M>
class AppliedEach : public Applied<T, M> {
public:
    AppliedEach(Moved moved, Motors motors) : Applied<T, M>(moved, Pairing::each, motors), motors_(motors) {}

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::motors, 8, sizeof(M)}, Applied<T, M>::inputs()[0]};
    }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        ApplyCall<T> arguments = this->call(out, inputs[1], count);
        arguments.motors = inputs[0];
        return this->apply(arguments);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        M motor[8];
        draw_motor(random, motors_ == Motors::unit ? any_unit_regime(random) : any_regime(random), motor);
        std::memcpy(inputs[0], motor, sizeof motor);
        draw_operand(random, this->moved(), inputs[1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return this->expect_applied(motor_among<M>(inputs[0]).data(), inputs[1]);
    }

    static Subjects<T> all(Moved moved, Motors motors)
    {
        Subjects<T> subjects;
        subjects.push_back(std::make_unique<AppliedEach>(moved, motors));
        return subjects;
    }

private:
    Motors motors_;
};

// Each run has its indices in an array of another type, stride and place, against a forbidden page; the palette lies
// against one of its own.
template <class T, class M>
class AppliedIndexed : public Applied<T, M> {
public:
    AppliedIndexed(Moved moved, Motors motors, std::size_t palette_size, Guard guard)
        : Applied<T, M>(moved, Pairing::indexed, motors), palette_(8 * palette_size)
    {
        Random random(palette_size);
        for (std::size_t k = 0; k < palette_size; ++k)
            draw_motor(random, motors == Motors::unit ? any_unit_regime(random) : any_regime(random),
                       &palette_[8 * k]);
        placed_ = guarded_.place_copy(palette_.data(), palette_.size(), guard);
    }

    std::string name() const override
    {
        return Applied<T, M>::name() + ", a palette of " + std::to_string(size()) + ", " + indices_.describe();
    }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        return {{Operand::indices, 1}, Applied<T, M>::inputs()[0]};
    }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        ApplyCall<T> arguments = this->call(out, inputs[1], count);
        arguments.motor = placed_;
        arguments.motor_count = size();
        arguments.indices = indices_.place(inputs[0], count, size());
        const mw_status status = this->apply(arguments);
        indices_.expect_unchanged();
        return status;
    }

    void draw(Random &random, T *const *inputs) const override
    {
        *inputs[0] = static_cast<T>(random.chance(8) ? size() - 1 : random.below(size()));
        draw_operand(random, this->moved(), inputs[1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return this->expect_applied(&palette_[8 * static_cast<std::size_t>(*inputs[0])], inputs[1]);
    }

    static Subjects<T> all(Moved moved, Motors motors)
    {
        Subjects<T> subjects;
        for (std::size_t palette_size : {7, 300, 1})
            for (Guard guard : {Guard::after, Guard::before})
                if (palette_size != 300 || guard == Guard::after)
                    subjects.push_back(std::make_unique<AppliedIndexed>(moved, motors, palette_size, guard));
        return subjects;
    }

private:
    std::size_t size() const { return palette_.size() / 8; }

    std::vector<M> palette_;
    GuardedBuffer guarded_{palette_.size() * sizeof(M)};
    M *placed_;
    mutable IndexArray indices_;
};

#define MOTORWAY_TEST_SUBJECTS(operand, views, P)                                                                    \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_one()                                                                  \
    {                                                                                                                \
        return AppliedOne<T, T>::all(Moved::operand, Pairing::one);                                                  \
    }                                                                                                                \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_grid()                                                                 \
    {                                                                                                                \
        return AppliedOne<T, T>::all(Moved::operand, Pairing::grid);                                                 \
    }                                                                                                                \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_each()                                                                 \
    {                                                                                                                \
        return AppliedEach<T, T>::all(Moved::operand, Motors::any);                                                  \
    }                                                                                                                \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_each_unit()                                                            \
    {                                                                                                                \
        return AppliedEach<T, T>::all(Moved::operand, Motors::unit);                                                 \
    }                                                                                                                \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_indexed()                                                              \
    {                                                                                                                \
        return AppliedIndexed<T, T>::all(Moved::operand, Motors::any);                                               \
    }                                                                                                                \
    template <class T>                                                                                               \
    Subjects<T> subjects_of_apply_##operand##_indexed_unit()                                                         \
    {                                                                                                                \
        return AppliedIndexed<T, T>::all(Moved::operand, Motors::unit);                                              \
    }

MW_OPERANDS(MOTORWAY_TEST_SUBJECTS, )
#undef MOTORWAY_TEST_SUBJECTS

inline Subjects<float> subjects_of_apply_point_one_mixed()
{
    return AppliedOne<float, double>::all(Moved::point, Pairing::one);
}
inline Subjects<float> subjects_of_apply_point_grid_mixed()
{
    return AppliedOne<float, double>::all(Moved::point, Pairing::grid);
}
// A promise of normalised motors is allowed here too.
inline Subjects<float> subjects_of_apply_point_each_mixed()
{
    Subjects<float> subjects = AppliedEach<float, double>::all(Moved::point, Motors::any);
    for (auto &subject : AppliedEach<float, double>::all(Moved::point, Motors::unit))
        subjects.push_back(std::move(subject));
    return subjects;
}
inline Subjects<float> subjects_of_apply_point_indexed_mixed()
{
    Subjects<float> subjects = AppliedIndexed<float, double>::all(Moved::point, Motors::any);
    for (auto &subject : AppliedIndexed<float, double>::all(Moved::point, Motors::unit))
        subjects.push_back(std::move(subject));
    return subjects;
}

}  // namespace motorway::testing

#endif
