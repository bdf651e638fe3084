// The subjects blend motor one and blend motor each.
#ifndef MOTORWAY_TESTS_BLEND_TESTER_H
#define MOTORWAY_TESTS_BLEND_TESTER_H

#include <array>

#include "guarded_buffer.h"
#include "motors.h"
#include "subject.h"

namespace motorway::testing {

// A sum of K products: each is at most K roundings away from the result.
template <class T>
Expected expect_blend(const T *weights, const std::vector<const T *> &controls)
{
    std::vector<reference::Real> exact_weights;
    std::vector<reference::Motor> exact_controls;
    std::array<long double, 8> magnitudes{};
    for (std::size_t k = 0; k < controls.size(); ++k) {
        exact_weights.emplace_back(weights[k]);
        exact_controls.push_back(exact_motor(controls[k]));
        for (std::size_t c = 0; c < 8; ++c)
            magnitudes[c] += std::abs(static_cast<long double>(weights[k]) * controls[k][c]);
    }
    const reference::Motor value = reference::blend(exact_weights, exact_controls);
    const long double terms = static_cast<long double>(controls.size());
    Expected expected;
    for (std::size_t c = 0; c < 8; ++c) {
        expected.value.push_back(value[c]);
        expected.tolerance.push_back(terms * (epsilon<T> / 2 * magnitudes[c] + underflow<T>));
    }
    return expected;
}

template <class T>
void draw_weights(Random &random, T *weights, std::size_t terms)
{
    for (std::size_t k = 0; k < terms; ++k)
        weights[k] = static_cast<T>(random.chance(8) ? 0 : random.uniform(-0.5, 1));
}

template <class T>
class BlendOne : public Subject<T> {
public:
    BlendOne(Random &random, std::size_t terms, Guard guard) : terms_(terms), controls_(8 * terms)
    {
        for (std::size_t k = 0; k < terms; ++k)
            draw_motor(random, any_regime(random), &controls_[8 * k]);
        placed_ = guarded_.place_copy(controls_.data(), controls_.size(), guard);
    }

    std::string name() const override { return "blend_motor_one of " + std::to_string(terms_) + " terms"; }
    std::vector<typename Subject<T>::Input> inputs() const override { return {{Operand::weights, terms_}}; }
    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        const auto *controls = reinterpret_cast<const typename api<T>::motor *>(placed_);
        return api<T>::blend_motor_one(out.motors(), controls, inputs[0].weights(), terms_, count);
    }

    void draw(Random &random, T *const *inputs) const override { draw_weights(random, inputs[0], terms_); }

    Expected expect(const T *const *inputs) const override
    {
        std::vector<const T *> controls;
        for (std::size_t k = 0; k < terms_; ++k)
            controls.push_back(&controls_[8 * k]);
        return expect_blend(inputs[0], controls);
    }

private:
    std::size_t terms_;
    std::vector<T> controls_;
    GuardedBuffer guarded_{(terms_ + 1) * sizeof(T[8])};
    T *placed_;
};

template <class T>
class BlendEach : public Subject<T> {
public:
    explicit BlendEach(std::size_t terms) : terms_(terms) {}

    std::string name() const override { return "blend_motor_each of " + std::to_string(terms_) + " terms"; }

    std::vector<typename Subject<T>::Input> inputs() const override
    {
        std::vector<typename Subject<T>::Input> inputs(terms_, {Operand::motors, 8});
        inputs.insert(inputs.begin(), {Operand::weights, terms_});
        return inputs;
    }

    Operand output() const override { return Operand::motors; }

    mw_status run(const View<T> &out, const std::vector<View<T>> &inputs, std::size_t count) const override
    {
        std::vector<typename api<T>::const_motors> controls;
        for (std::size_t k = 0; k < terms_; ++k)
            controls.push_back(inputs[k + 1].const_motors());
        return api<T>::blend_motor_each(out.motors(), controls.data(), inputs[0].weights(), terms_, count);
    }

    void draw(Random &random, T *const *inputs) const override
    {
        draw_weights(random, inputs[0], terms_);
        for (std::size_t k = 0; k < terms_; ++k)
            draw_motor(random, any_regime(random), inputs[k + 1]);
    }

    Expected expect(const T *const *inputs) const override
    {
        return expect_blend(inputs[0], std::vector<const T *>(inputs + 1, inputs + 1 + terms_));
    }

private:
    std::size_t terms_;
};

constexpr std::size_t blend_terms[] = {3, 0, 1, 2, 4, 9};

template <class T>
Subjects<T> subjects_of_blend_motor_one()
{
    Subjects<T> subjects;
    Random random(2);
    for (std::size_t terms : blend_terms)
        for (Guard guard : {Guard::after, Guard::before})
            subjects.push_back(std::make_unique<BlendOne<T>>(random, terms, guard));
    return subjects;
}

template <class T>
Subjects<T> subjects_of_blend_motor_each()
{
    Subjects<T> subjects;
    for (std::size_t terms : blend_terms)
        subjects.push_back(std::make_unique<BlendEach<T>>(terms));
    return subjects;
}

}  // namespace motorway::testing

#endif
