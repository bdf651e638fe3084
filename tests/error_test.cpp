// Every status: what causes it, and that nothing is written then. apply_error_test.cpp has what only the apply
// functions have, motion_error_test.cpp what motions have.

#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "kernel_list.h"
#include "overlap.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

TEST(StatusText, every_status_has_a_line_of_its_own)
{
    std::set<std::string> texts;
    for (int status = MW_OK; status <= int(MW_ERROR_ISA); ++status) {
        const char *text = mw_status_text(static_cast<mw_status>(status));
        ASSERT_NE(text, nullptr) << status;
        EXPECT_GT(std::strlen(text), 3u) << status;
        EXPECT_EQ(std::strchr(text, '\n'), nullptr) << text;
        EXPECT_TRUE(texts.insert(text).second) << text;
    }
}

TEST(StatusText, an_unknown_number_has_a_line_too)
{
    const char *text = mw_status_text(static_cast<mw_status>(MW_ERROR_ISA + 1));
    ASSERT_NE(text, nullptr);
    EXPECT_GT(std::strlen(text), 3u);
    EXPECT_STRNE(text, mw_status_text(MW_OK));
}

TEST(StatusText, of_an_instruction_set_names_those_that_run)
{
    EXPECT_NE(std::strstr(mw_status_text(MW_ERROR_ISA), mw_isas()), nullptr);
}

// The operands of a kernel in one block of memory, each element followed by a gap, each operand by a margin. A test
// spoils a view and expects a status, and that not a byte of the block changes.
template <class T>
class Operands {
public:
    static constexpr std::size_t count = 20, stride = 32 * sizeof(T), margin = 64 * sizeof(T);

    explicit Operands(const Subject<T> &subject) : subject_(subject), kinds_(subject.inputs())
    {
        kinds_.push_back({subject.output(), subject.output_components()});
        memory_.assign(kinds_.size() * (count * stride + margin) + margin, 0xcd);
        for (std::size_t k = 0; k < kinds_.size(); ++k)
            views.push_back(aos(at(margin + k * (count * stride + margin)), kinds_[k].components, kinds_[k].scalar));
        draw_inputs();
    }

    View<T> &out() { return views.back(); }
    View<T> &input(std::size_t k) { return views[k]; }
    Operand kind(std::size_t k) const { return kinds_[k].operand; }
    std::size_t scalar(std::size_t k) const { return kinds_[k].scalar; }
    std::size_t element_bytes(std::size_t k) const { return kinds_[k].components * kinds_[k].scalar; }

    View<T> aos(unsigned char *first, std::size_t components, std::size_t scalar_size = sizeof(T)) const
    {
        View<T> view;
        for (std::size_t c = 0; c < components; ++c)
            view.component.push_back(reinterpret_cast<T *>(first + c * scalar_size));
        view.stride = stride;
        return view;
    }

    unsigned char *address(const View<T> &view) const { return reinterpret_cast<unsigned char *>(view.component[0]); }

    mw_status run(std::size_t elements = count)
    {
        return subject_.run(out(), std::vector<View<T>>(views.begin(), views.end() - 1), elements);
    }

    void expect(mw_status status, const std::string &what, std::size_t elements = count)
    {
        const std::vector<unsigned char> before = memory_;
        const mw_status got = run(elements);
        const std::string name = subject_.name() + " " + api<T>::name + ", " + what;
        EXPECT_EQ(got, status) << name << ": " << mw_status_text(got);
        EXPECT_TRUE(memory_ == before) << name << ": bytes changed";
    }

    // The output lies over input k. That is in place if no element lies over another one.
    void expect_by_bytes(std::size_t k, const std::string &what)
    {
        if (subject_.keeps_apart() || lies_over_another_element(out(), input(k), scalar(k), count))
            return expect(MW_ERROR_OVERLAP, what);
        const std::vector<unsigned char> before = memory_;
        EXPECT_EQ(run(), MW_OK) << subject_.name() << " " << api<T>::name << ", " << what;
        memory_ = before;
    }

    std::vector<View<T>> views;

private:
    unsigned char *at(std::size_t offset) { return memory_.data() + offset; }

    void draw_inputs()
    {
        Random random(61);
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<std::vector<T>> element;
            std::vector<T *> pointers;
            for (const auto &input : subject_.inputs())
                element.emplace_back(input.size() + 1);
            for (auto &components : element)
                pointers.push_back(components.data());
            subject_.draw(random, pointers.data());
            for (std::size_t k = 0; k < element.size(); ++k)
                std::memcpy(address(views[k]) + i * stride, element[k].data(), element_bytes(k));
        }
    }

    const Subject<T> &subject_;
    std::vector<typename Subject<T>::Input> kinds_;  // of the inputs and of the output
    std::vector<unsigned char> memory_;
};

template <class T>
class ErrorTest : public ::testing::Test {
protected:
    // Once for every kernel of the list, with operands of its own.
    static void for_every_kernel(const std::function<void(const Subject<T> &, Operands<T>)> &body)
    {
        for (const KernelRow &row : kernel_rows()) {
            const auto subjects = row.subjects<T>();
            if (subjects.empty())
                continue;  // a mixed kernel is one of floats
            Operands<T> operands(*subjects.front());
            ASSERT_EQ(operands.run(), MW_OK) << row.name << ": the operands are not even valid";
            body(*subjects.front(), Operands<T>(*subjects.front()));
        }
    }
};

TYPED_TEST_SUITE(ErrorTest, Precisions, PrecisionName);

TYPED_TEST(ErrorTest, a_null_component_of_any_operand)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &, Operands<T> operands) {
        for (std::size_t k = 0; k < operands.views.size(); ++k)
            for (T *&component : operands.views[k].component) {
                T *const kept = std::exchange(component, nullptr);
                operands.expect(MW_ERROR_NULL, "null");
                component = kept;
                if (is_matrix(operands.kind(k)))
                    break;  // the first is all there is
            }
    });
}

// One byte less than the element, one scalar, nothing.
TYPED_TEST(ErrorTest, a_stride_smaller_than_the_element)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &, Operands<T> operands) {
        for (std::size_t k = 0; k < operands.views.size(); ++k) {
            if (operands.kind(k) == Operand::indices)
                continue;  // the subject's own array; see apply_error_test.cpp
            View<T> &view = operands.views[k];
            const std::size_t scalar = operands.scalar(k);
            const std::size_t element = scalar * components_of_a_view(operands.kind(k));
            for (std::size_t stride : {element - 1, element - scalar, scalar - 1, std::size_t(0)}) {
                if (stride == 0 && operands.kind(k) == Operand::numbers)
                    continue;  // one number for all
                view.stride = stride;
                operands.expect(MW_ERROR_STRIDE,
                                "operand " + std::to_string(k) + ", stride " + std::to_string(stride));
            }
            view.stride = operands.stride;
        }
    });
}

// A stride is large enough, and two components are the same or half of each other.
TYPED_TEST(ErrorTest, components_of_one_view_that_share_bytes)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &, Operands<T> operands) {
        for (std::size_t k = 0; k < operands.views.size(); ++k) {
            // Weights are an array for each term, and two terms may well have the same.
            if (operands.kind(k) == Operand::weights || operands.kind(k) == Operand::indices ||
                operands.kind(k) == Operand::numbers || is_matrix(operands.kind(k)))
                continue;
            View<T> &view = operands.views[k];
            T *const kept = view.component[2];
            const std::ptrdiff_t scalar = static_cast<std::ptrdiff_t>(operands.scalar(k));
            for (std::ptrdiff_t bytes : {std::ptrdiff_t(0), std::ptrdiff_t(1), scalar - 1,
                                         std::ptrdiff_t(operands.stride), 1 - std::ptrdiff_t(operands.stride)}) {
                view.component[2] = reinterpret_cast<T *>(reinterpret_cast<char *>(view.component[1]) + bytes);
                operands.expect(MW_ERROR_STRIDE,
                                "component 2 is " + std::to_string(bytes) + " bytes behind component 1");
            }
            view.component[2] = kept;
        }
    });
}

TYPED_TEST(ErrorTest, a_size_beyond_the_address_space)
{
    using T = TypeParam;
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    this->for_every_kernel([](const Subject<T> &, Operands<T> operands) {
        for (std::size_t elements : {most, most / 2, most / operands.stride + 1, most / operands.stride})
            operands.expect(MW_ERROR_SIZE, std::to_string(elements) + " elements", elements);
    });
    this->for_every_kernel([](const Subject<T> &, Operands<T> operands) {
        for (std::size_t k = 0; k < operands.views.size(); ++k) {
            if (operands.kind(k) == Operand::indices)
                continue;
            operands.views[k].stride = most / 4;
            operands.expect(MW_ERROR_SIZE, "a stride of a quarter of the address space");
            operands.views[k].stride = operands.stride;
        }
    });
}

TYPED_TEST(ErrorTest, an_output_that_overlaps_an_input_in_part)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &subject, Operands<T> operands) {
        const View<T> out = operands.out();
        const std::ptrdiff_t stride = operands.stride, scalar = sizeof(T), count = operands.count;
        for (std::size_t k = 0; k < subject.inputs().size(); ++k) {
            if (operands.kind(k) == Operand::indices)
                continue;
            const View<T> &input = operands.input(k);
            const std::ptrdiff_t in_bytes = (count - 1) * stride + std::ptrdiff_t(operands.element_bytes(k));
            const std::ptrdiff_t out_bytes = (count - 1) * stride + scalar * std::ptrdiff_t(out.component.size());
            // By a byte, a component, an element; then by the last byte of one and the first of the other.
            for (std::ptrdiff_t shift : {std::ptrdiff_t(1), std::ptrdiff_t(-1), scalar, -scalar, stride, -stride,
                                         stride + 1, 3 * stride, in_bytes - 1, 1 - out_bytes}) {
                if (shift == std::ptrdiff_t(operands.element_bytes(k)))
                    continue;  // behind a number it is in the gap
                operands.out() = operands.aos(operands.address(input) + shift, out.component.size());
                operands.expect_by_bytes(k, "the output is " + std::to_string(shift) + " bytes behind input " +
                                                std::to_string(k));
            }
            for (std::size_t other : {operands.stride + sizeof(T), operands.stride + 1, 2 * operands.stride}) {
                operands.out() = operands.aos(operands.address(input), out.component.size());
                operands.out().stride = other;
                operands.expect(MW_ERROR_OVERLAP, "a stride of " + std::to_string(other) + " in place of input " +
                                                      std::to_string(k));
            }
        }
        operands.out() = out;
    });
}

// Components exchanged, or some of them elsewhere: in place, unless they are those of another element.
TYPED_TEST(ErrorTest, an_output_made_of_components_of_an_input)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &subject, Operands<T> operands) {
        const View<T> out = operands.out();
        for (std::size_t k = 0; k < subject.inputs().size(); ++k) {
            if (operands.kind(k) == Operand::indices)
                continue;
            if (operands.kind(k) == subject.output() && !is_matrix(subject.output())) {
                operands.out() = operands.input(k);
                std::swap(operands.out().component[0], operands.out().component[1]);
                operands.expect_by_bytes(k, "components 0 and 1 of input " + std::to_string(k) + " exchanged");
            }
            for (std::size_t to : {0, 2})
                for (std::size_t from : {0, 2})
                    for (std::ptrdiff_t elements : {0, 1, -1}) {
                        if (from >= operands.input(k).component.size() || is_matrix(subject.output()))
                            continue;
                        operands.out() = out;
                        auto *const component = reinterpret_cast<unsigned char *>(operands.input(k).component[from]);
                        operands.out().component[to] =
                            reinterpret_cast<T *>(component + elements * std::ptrdiff_t(operands.stride));
                        operands.expect_by_bytes(k, "component " + std::to_string(to) + " is component " +
                                                        std::to_string(from) + " of input " + std::to_string(k) +
                                                        ", " + std::to_string(elements) + " elements behind");
                    }
        }
    });
}

// In place of one input is fine, and no excuse for the other.
TYPED_TEST(ErrorTest, an_output_in_place_of_one_input_that_overlaps_another)
{
    using T = TypeParam;
    const auto subjects = subjects_of_compose_motor_each<T>();
    for (std::size_t k : {0, 1}) {
        Operands<T> operands(*subjects.front());
        operands.out() = operands.input(k);
        ASSERT_EQ(operands.run(), MW_OK);
        operands.input(1 - k) = operands.aos(operands.address(operands.input(k)) + operands.stride, 8);
        operands.expect(MW_ERROR_OVERLAP, "the other input is one element behind");
    }
}

// Neighbours that touch, before and behind, share nothing: here the output lies in the gaps of each input. Only the
// range of a grid, gaps included, is its own.
TYPED_TEST(ErrorTest, an_output_that_touches_an_input_is_no_overlap)
{
    using T = TypeParam;
    this->for_every_kernel([](const Subject<T> &subject, Operands<T> operands) {
        const std::size_t components = operands.out().component.size();
        const mw_status status = subject.keeps_apart() ? MW_ERROR_OVERLAP : MW_OK;
        for (std::size_t k = 0; k < subject.inputs().size(); ++k) {
            if (operands.kind(k) == Operand::indices)
                continue;
            unsigned char *const first = operands.address(operands.input(k));
            operands.out() = operands.aos(first + operands.element_bytes(k), components);
            EXPECT_EQ(operands.run(), status) << subject.name();
            operands.out() = operands.aos(first - components * sizeof(T), components);
            EXPECT_EQ(operands.run(), status) << subject.name();
        }
    });
}

TYPED_TEST(ErrorTest, a_count_of_0_takes_null_pointers)
{
    using T = TypeParam;
    using A = api<T>;
    const typename A::motors no_motors = A::motors_aos(nullptr, 0);
    const typename A::const_motors no_const_motors = A::const_motors_aos(nullptr, 0);
    const typename A::weights no_weights = {nullptr, 0};
    EXPECT_EQ(A::compose_motor_each(no_motors, no_const_motors, no_const_motors, 0), MW_OK);
    EXPECT_EQ(A::reverse_motor_each(no_motors, no_const_motors, 0), MW_OK);
    EXPECT_EQ(A::normalize_motor_each(no_motors, no_const_motors, 0), MW_OK);
    EXPECT_EQ(A::blend_motor_one(no_motors, nullptr, no_weights, 3, 0), MW_OK);
    EXPECT_EQ(A::blend_motor_each(no_motors, nullptr, no_weights, 3, 0), MW_OK);
    EXPECT_EQ(A::check_motors(no_const_motors, 0, nullptr), MW_OK);
}

TYPED_TEST(ErrorTest, an_axis_of_length_zero_or_not_finite)
{
    using T = TypeParam;
    using A = api<T>;
    using Limits = std::numeric_limits<T>;
    const T nan = Limits::quiet_NaN(), infinity = Limits::infinity();
    const T good[3] = {0, 0, 1};
    const auto expect_error = [](mw_status status, const T *axis, T angle, const T *point) {
        typename A::motor motor{7, 7, 7, 7, 7, 7, 7, 7};
        EXPECT_EQ(A::rotation(&motor, axis, angle, point), status);
        for (std::size_t c = 0; c < 8; ++c)
            EXPECT_EQ((&motor.s)[c], T(7));
    };
    const T zero[3] = {0, -T(0), 0};
    expect_error(MW_ERROR_AXIS, zero, 1, nullptr);
    for (T bad : {nan, infinity, -infinity})
        for (std::size_t k = 0; k < 3; ++k) {
            T spoilt[3] = {1, 2, 3};
            spoilt[k] = bad;
            expect_error(MW_ERROR_AXIS, spoilt, 1, nullptr);
            expect_error(MW_ERROR_AXIS, good, 1, spoilt);
            expect_error(MW_ERROR_AXIS, good, bad, nullptr);
        }
    expect_error(MW_ERROR_NULL, nullptr, 1, good);
    EXPECT_EQ(A::rotation(nullptr, good, T(1), nullptr), MW_ERROR_NULL);
    typename A::motor motor;
    EXPECT_EQ(A::translation(nullptr, good), MW_ERROR_NULL);
    EXPECT_EQ(A::translation(&motor, nullptr), MW_ERROR_NULL);
}

TYPED_TEST(ErrorTest, checking_motors_in_a_view_that_is_wrong)
{
    using T = TypeParam;
    using A = api<T>;
    const typename A::motor motors[2] = {{1, 0, 0, 0, 0, 0, 0, 0}, {1, 0, 0, 0, 0, 0, 0, 0}};
    const std::size_t size = sizeof motors[0], most = std::numeric_limits<std::size_t>::max();
    EXPECT_EQ(A::check_motors(A::const_motors_aos(nullptr, size), 2, nullptr), MW_ERROR_NULL);
    EXPECT_EQ(A::check_motors(A::const_motors_aos(motors, size - 1), 2, nullptr), MW_ERROR_STRIDE);
    EXPECT_EQ(A::check_motors(A::const_motors_aos(motors, 0), 2, nullptr), MW_ERROR_STRIDE);
    EXPECT_EQ(A::check_motors(A::const_motors_aos(motors, size), most / 2, nullptr), MW_ERROR_SIZE);
}

// Both blends of two terms, one element, everything in arrays of scalars.
template <class T>
struct Blend {
    using A = api<T>;
    T controls[16] = {1, 0, 0, 0, 5, 6, 7, 8, 1, 0, 0, 0, 1, 2, 3, 4};
    T weights[2] = {1, 1};
    T out[8] = {7, 7, 7, 7, 7, 7, 7, 7};
    const T *terms[2] = {&weights[0], &weights[1]};
    const typename A::motor *control(std::size_t k) const
    {
        return reinterpret_cast<const typename A::motor *>(controls + 8 * k);
    }
    typename A::const_motors views[2] = {A::const_motors_aos(control(0), sizeof(T[8])),
                                        A::const_motors_aos(control(1), sizeof(T[8]))};

    void expect(mw_status status, const typename A::motor *one, const typename A::const_motors *each,
                const T *const *term_pointers, std::size_t term_count = 2)
    {
        const typename A::weights view = {term_pointers, sizeof(T)};
        const auto to = A::motors_aos(reinterpret_cast<typename A::motor *>(out), sizeof out);
        EXPECT_EQ(A::blend_motor_one(to, one, view, term_count, 1), status);
        EXPECT_EQ(A::blend_motor_each(to, each, view, term_count, 1), status);
        for (T number : out)
            EXPECT_EQ(number, T(7));
    }
};

TYPED_TEST(ErrorTest, a_blend_without_its_controls_or_weights)
{
    using T = TypeParam;
    Blend<T> blend;
    blend.expect(MW_ERROR_NULL, nullptr, nullptr, blend.terms);
    blend.expect(MW_ERROR_NULL, blend.control(0), blend.views, nullptr);
    for (std::size_t k : {0, 1}) {
        const T *terms[2] = {blend.terms[0], blend.terms[1]};
        terms[k] = nullptr;
        blend.expect(MW_ERROR_NULL, blend.control(0), blend.views, terms);
    }
    // Without terms nothing of the kind is needed.
    typename api<T>::motor sum{7, 7, 7, 7, 7, 7, 7, 7};
    const auto out = api<T>::motors_aos(&sum, sizeof sum);
    EXPECT_EQ(api<T>::blend_motor_one(out, nullptr, {nullptr, 0}, 0, 1), MW_OK);
    EXPECT_EQ(sum.s, T(0));
    sum.s = 7;
    EXPECT_EQ(api<T>::blend_motor_each(out, nullptr, {nullptr, 0}, 0, 1), MW_OK);
    EXPECT_EQ(sum.s, T(0));
}

TYPED_TEST(ErrorTest, an_output_over_the_controls_of_a_blend)
{
    using T = TypeParam;
    using A = api<T>;
    Blend<T> blend;
    const Blend<T> before = blend;
    for (std::size_t at : {0, 1, 7, 8}) {
        const auto out = A::motors_aos(reinterpret_cast<typename A::motor *>(blend.controls + at), sizeof(T[8]));
        EXPECT_EQ(A::blend_motor_one(out, blend.control(0), {blend.terms, sizeof(T)}, 2, 1), MW_ERROR_OVERLAP);
        EXPECT_EQ(std::memcmp(blend.controls, before.controls, sizeof blend.controls), 0);
    }
}

TYPED_TEST(ErrorTest, more_controls_than_the_address_space_holds)
{
    using T = TypeParam;
    using A = api<T>;
    Blend<T> blend;
    const auto out = A::motors_aos(reinterpret_cast<typename A::motor *>(blend.out), sizeof blend.out);
    const std::size_t most = std::numeric_limits<std::size_t>::max();
    for (std::size_t terms : {most, most / sizeof(T[8]) + 2, most / 4})
        EXPECT_EQ(A::blend_motor_one(out, blend.control(0), {blend.terms, sizeof(T)}, terms, 1), MW_ERROR_SIZE);
}

TYPED_TEST(ErrorTest, more_separate_controls_than_a_blend_takes)
{
    using T = TypeParam;
    using A = api<T>;
    Blend<T> blend;
    std::vector<const T *> terms(MW_MAX_TERMS + 1, &blend.weights[0]);
    std::vector<typename A::const_motors> controls(terms.size(), blend.views[0]);
    const auto out = A::motors_aos(reinterpret_cast<typename A::motor *>(blend.out), sizeof blend.out);
    for (std::size_t count : {std::size_t(MW_MAX_TERMS) + 1, std::numeric_limits<std::size_t>::max()})
        EXPECT_EQ(A::blend_motor_each(out, controls.data(), {terms.data(), sizeof(T)}, count, 1),
                  MW_ERROR_TERM_COUNT);
    for (T number : blend.out)
        EXPECT_EQ(number, T(7));
    // The most it takes; a blend of controls that all elements share takes more.
    EXPECT_EQ(A::blend_motor_each(out, controls.data(), {terms.data(), sizeof(T)}, MW_MAX_TERMS, 1), MW_OK);
    EXPECT_EQ(blend.out[0], T(MW_MAX_TERMS));
    std::vector<T> many(8 * terms.size(), T(1));
    EXPECT_EQ(A::blend_motor_one(out, reinterpret_cast<const typename A::motor *>(many.data()),
                                 {terms.data(), sizeof(T)}, terms.size(), 1),
              MW_OK);
    EXPECT_EQ(blend.out[0], T(MW_MAX_TERMS + 1));
}

}  // namespace
}  // namespace motorway::testing
