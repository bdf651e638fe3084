// What can be wrong with calls of the conversions beyond their views, which error_test.cpp spoils for every kernel:
// the two views of a pose, matrices, layouts, orders, scales and flags. And that nothing is written then.

#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "convert_api.h"
#include "kernel_tester.h"
#include "precisions.h"

namespace motorway::testing {
namespace {

constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
constexpr unsigned all_matrix_flags[] = {MW_DEFAULT, MW_NEAREST_ROTATION, MW_ROTATION_MATRICES};

template <class T>
class ConvertErrorTest : public ::testing::Test {
protected:
    static constexpr std::size_t count = 6, room = 20 * count;  // elements of up to 16 numbers, and some more

    ConvertErrorTest() : numbers_(4 * room, T(1)) {}

    T *first() { return &numbers_[0]; }
    T *second() { return &numbers_[room]; }
    T *third() { return &numbers_[2 * room]; }

    static auto motors(T *components) { return packed_view(components, 8).motors(); }
    static auto const_motors(T *components) { return packed_view(components, 8).const_motors(); }
    static auto xyz(T *components) { return packed_view(components, 3).xyz(); }
    static auto const_xyz(T *components) { return packed_view(components, 3).const_xyz(); }

    static typename api<T>::matrices matrices(T *numbers, mw_matrix_layout layout)
    {
        return {numbers, numbers_of(layout) * sizeof(T), layout};
    }
    static typename api<T>::const_matrices const_matrices(const T *numbers, mw_matrix_layout layout)
    {
        return {numbers, numbers_of(layout) * sizeof(T), layout};
    }

    template <class Call>
    void expect(mw_status status, Call call, const std::string &what = "")
    {
        const std::vector<T> before = numbers_;
        const mw_status got = call();
        EXPECT_EQ(got, status) << what << ": " << mw_status_text(got);
        EXPECT_EQ(std::memcmp(before.data(), numbers_.data(), before.size() * sizeof(T)), 0)
            << what << ": bytes changed";
    }

private:
    std::vector<T> numbers_;
};

TYPED_TEST_SUITE(ConvertErrorTest, Precisions, PrecisionName);

// ------------------------------------------------------------------------------------------------------------- poses

// The functions that have a rotation in four numbers or three, and a translation. Each argument is a view of its own,
// so any of them can be spoilt alone.
template <class T>
struct PoseViews {
    View<T> rotation, translation, motors;
    std::size_t count;
};

template <class T>
struct PoseFunction {
    std::string name;
    std::size_t numbers;  // of a rotation
    std::function<mw_status(const PoseViews<T> &)> run;
};

template <class T>
std::vector<PoseFunction<T>> pose_functions()
{
    using C = api<T>;
    using A = api<T>;
    using Views = const PoseViews<T> &;
    const auto rotations = [](Views v) { return quaternions<typename C::xyzw>(v.rotation, x_first); };
    const auto const_rotations = [](Views v) { return quaternions<typename C::const_xyzw>(v.rotation, x_first); };
    return {
        {"motor_to_pose", 4,
         [=](Views v) {
             return C::convert_motor_to_pose_each(rotations(v), v.translation.xyz(), v.motors.const_motors(), v.count);
         }},
        {"pose_to_motor", 4,
         [=](Views v) {
             return C::convert_pose_to_motor_each(v.motors.motors(), const_rotations(v), v.translation.const_xyz(), v.count);
         }},
        {"motor_to_axis_angle", 4,
         [=](Views v) {
             return C::convert_motor_to_axis_angle_each(rotations(v), v.translation.xyz(), v.motors.const_motors(), v.count);
         }},
        {"axis_angle_to_motor", 4,
         [=](Views v) {
             return C::convert_axis_angle_to_motor_each(v.motors.motors(), const_rotations(v), v.translation.const_xyz(), v.count);
         }},
        {"motor_to_euler", 3,
         [](Views v) {
             return C::convert_motor_to_euler_each(vectors<typename A::xyz>(v.rotation, 0), v.translation.xyz(),
                                      v.motors.const_motors(), v.count, MW_EULER_ZYX);
         }},
        {"euler_to_motor", 3,
         [](Views v) {
             return C::convert_euler_to_motor_each(v.motors.motors(), vectors<typename A::const_xyz>(v.rotation, 0),
                                      v.translation.const_xyz(), v.count, MW_EULER_ZYX);
         }},
    };
}

TYPED_TEST(ConvertErrorTest, every_view_of_a_pose)
{
    using T = TypeParam;
    for (const PoseFunction<T> &function : pose_functions<T>()) {
        const PoseViews<T> good{packed_view(this->first(), function.numbers), packed_view(this->second(), 3),
                                packed_view(this->third(), 8), this->count};
        const auto expect = [&](mw_status status, const PoseViews<T> &views, const char *what) {
            this->expect(status, [&] { return function.run(views); }, function.name + ", " + what);
        };
        for (View<T> PoseViews<T>::*view : {&PoseViews<T>::rotation, &PoseViews<T>::translation,
                                            &PoseViews<T>::motors}) {
            for (std::size_t c = 0; c < (good.*view).component.size(); ++c) {
                PoseViews<T> views = good;
                (views.*view).component[c] = nullptr;
                expect(MW_ERROR_NULL, views, "null");
            }
            for (std::size_t less : {std::size_t(1), sizeof(T), (good.*view).stride}) {
                PoseViews<T> views = good;
                (views.*view).stride -= less;
                expect(MW_ERROR_STRIDE, views, "stride");
            }
            PoseViews<T> views = good;
            (views.*view).component[1] = (views.*view).component[0];
            expect(MW_ERROR_STRIDE, views, "a component twice");
            views = good;
            views.count = most / (good.*view).stride + 1;
            expect(MW_ERROR_SIZE, views, "size");
        }
        EXPECT_EQ(function.run(good), MW_OK) << function.name;
    }
}

// Of what is written with what is read, by a number, and of the two that are written with each other.
TYPED_TEST(ConvertErrorTest, views_of_a_pose_that_overlap)
{
    using T = TypeParam;
    for (const PoseFunction<T> &function : pose_functions<T>()) {
        const std::size_t n = function.numbers;
        T *const rotation = this->first(), *const translation = this->second(), *const motors = this->third();
        const auto expect = [&](mw_status status, T *a, T *b, T *c, const char *what) {
            const PoseViews<T> views{packed_view(a, n), packed_view(b, 3), packed_view(c, 8), this->count};
            if (status != MW_OK)
                this->expect(status, [&] { return function.run(views); }, function.name + ", " + what);
            else
                EXPECT_EQ(function.run(views), MW_OK) << function.name << ", " << what;
        };
        for (T *place : {rotation, rotation + 1, rotation + n * this->count - 1, rotation - 8 * this->count + 1})
            if (place >= this->first())
                expect(MW_ERROR_OVERLAP, rotation, translation, place, "motors over rotations");
        expect(MW_ERROR_OVERLAP, rotation, motors + 8 * this->count - 1, motors, "translations over motors");
        expect(MW_ERROR_OVERLAP, rotation, translation, translation - 8 * this->count + 1,
               "motors over translations");
        const bool writes_poses = function.name.find("motor_to") == 0;
        for (T *place : {rotation, rotation + n * this->count - 1}) {
            if (writes_poses)
                expect(MW_ERROR_OVERLAP, rotation, place, motors, "translations over rotations");
            else
                expect(MW_OK, rotation, place, motors, "both are read alone");
        }
        expect(MW_OK, rotation, rotation + n * this->count, motors, "one behind the other");
    }
}

// As in memory that a rotation and a translation share, element by element.
TYPED_TEST(ConvertErrorTest, interleaved_views_of_a_pose)
{
    using T = TypeParam;
    for (const PoseFunction<T> &function : pose_functions<T>()) {
        PoseViews<T> views{packed_view(this->first(), function.numbers),
                           packed_view(this->first() + function.numbers, 3), packed_view(this->third(), 8),
                           this->count};
        views.rotation.stride = views.translation.stride = sizeof(T[7]);
        EXPECT_EQ(function.run(views), MW_OK) << function.name;
    }
}

// ---------------------------------------------------------------------------------------------------------- matrices

TYPED_TEST(ConvertErrorTest, views_of_matrices)
{
    using T = TypeParam;
    using C = api<T>;
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const std::string name = name_of(layout);
        // Of all three functions; the numbers that the check is not to write are among those compared.
        const auto expect = [&](mw_status status, T *first, std::size_t stride, std::size_t elements,
                                const char *what) {
            auto *const bad = reinterpret_cast<std::size_t *>(this->third());
            const auto motors = this->motors(this->second());
            const auto const_motors = this->const_motors(this->second());
            this->expect(status, [&] { return C::convert_motor_to_matrix_each({first, stride, layout}, const_motors, elements); },
                         name + " from motors, " + what);
            for (unsigned flags : all_matrix_flags)
                this->expect(status,
                             [&] { return C::convert_matrix_to_motor_each(motors, {first, stride, layout}, elements, flags, nullptr); },
                             name + " to motors, " + what);
            this->expect(status,
                         [&] {
                             return C::check_matrices({first, stride, layout}, elements, T(1), bad,
                                                      this->third() + 8);
                         },
                         name + " checked, " + what);
        };
        const std::size_t size = numbers_of(layout) * sizeof(T);
        expect(MW_ERROR_NULL, nullptr, size, this->count, "null");
        for (std::size_t stride : {size - 1, size - sizeof(T), sizeof(T), std::size_t(0)})
            expect(MW_ERROR_STRIDE, this->first(), stride, this->count, "stride");
        expect(MW_ERROR_SIZE, this->first(), size, most / size + 1, "size");
        expect(MW_ERROR_SIZE, this->first(), most / 4, 8, "size of a huge stride");
    }
}

TYPED_TEST(ConvertErrorTest, motors_that_are_no_view_and_matrices)
{
    using T = TypeParam;
    using C = api<T>;
    const mw_matrix_layout layout = MW_MATRIX_ROWS_3X4;
    for (std::size_t c = 0; c < 8; ++c) {
        View<T> view = packed_view(this->second(), 8);
        view.component[c] = nullptr;
        this->expect(MW_ERROR_NULL, [&] {
            return C::convert_motor_to_matrix_each(this->matrices(this->first(), layout), view.const_motors(), this->count);
        });
        for (unsigned flags : all_matrix_flags)
            this->expect(MW_ERROR_NULL, [&] {
                return C::convert_matrix_to_motor_each(view.motors(), this->const_matrices(this->first(), layout), this->count,
                                          flags, nullptr);
            });
    }
    View<T> narrow = packed_view(this->second(), 8);
    narrow.stride -= 1;
    this->expect(MW_ERROR_STRIDE, [&] {
        return C::convert_motor_to_matrix_each(this->matrices(this->first(), layout), narrow.const_motors(), this->count);
    });
    for (unsigned flags : all_matrix_flags)
        this->expect(MW_ERROR_STRIDE, [&] {
            return C::convert_matrix_to_motor_each(narrow.motors(), this->const_matrices(this->first(), layout), this->count,
                                      flags, nullptr);
        });
}

TYPED_TEST(ConvertErrorTest, matrices_over_motors)
{
    using T = TypeParam;
    using C = api<T>;
    for (mw_matrix_layout layout : all_matrix_layouts) {
        const std::size_t numbers = numbers_of(layout);
        T *const matrices = this->second();
        for (T *motors :
             {matrices, matrices + 1, matrices + numbers * this->count - 4, matrices - 8 * this->count + 1}) {
            this->expect(MW_ERROR_OVERLAP, [&] {
                return C::convert_motor_to_matrix_each(this->matrices(matrices, layout), this->const_motors(motors), this->count);
            });
            for (unsigned flags : all_matrix_flags) {
                this->expect(MW_ERROR_OVERLAP, [&] {
                    return C::convert_matrix_to_motor_each(this->motors(motors), this->const_matrices(matrices, layout),
                                              this->count, flags, nullptr);
                });
            }
        }
        EXPECT_EQ(C::convert_motor_to_matrix_each(this->matrices(matrices, layout),
                                     this->const_motors(matrices + numbers * this->count), this->count),
                  MW_OK);
        EXPECT_EQ(C::convert_matrix_to_motor_each(this->motors(matrices - 8 * this->count),
                                     this->const_matrices(matrices, layout), this->count, MW_ROTATION_MATRICES,
                                     nullptr),
                  MW_OK);
    }
}

TYPED_TEST(ConvertErrorTest, a_layout_that_is_none)
{
    using T = TypeParam;
    using C = api<T>;
    for (int number : {0, 5, 6, 7}) { // what fits the enumeration
        const auto layout = static_cast<mw_matrix_layout>(number);
        const std::size_t stride = sizeof(T[16]);
        this->expect(MW_ERROR_MATRIX_LAYOUT, [&] {
            return C::convert_motor_to_matrix_each({this->first(), stride, layout}, this->const_motors(this->second()), 1);
        });
        for (unsigned flags : all_matrix_flags)
            this->expect(MW_ERROR_MATRIX_LAYOUT, [&] {
                return C::convert_matrix_to_motor_each(this->motors(this->second()), {this->first(), stride, layout}, 1, flags,
                                          nullptr);
            });
        this->expect(MW_ERROR_MATRIX_LAYOUT, [&] {
            return C::check_matrices({this->first(), stride, layout}, 1, T(1), nullptr, this->third());
        });
    }
}

TYPED_TEST(ConvertErrorTest, flags_that_matrices_do_not_know)
{
    using T = TypeParam;
    using C = api<T>;
    for (unsigned flags : {unsigned(MW_UNIT_MOTORS), unsigned(MW_STREAMING_STORES), unsigned(MW_NO_STREAMING_STORES),
                           unsigned(MW_LONG_WAY), unsigned(MW_NEAREST_ROTATION | MW_UNIT_MOTORS),
                           unsigned(MW_NEAREST_ROTATION | MW_ROTATION_MATRICES), 1u << 20, ~0u})
        this->expect(MW_ERROR_FLAGS, [&] {
            return C::convert_matrix_to_motor_each(this->motors(this->second()),
                                      this->const_matrices(this->first(), MW_MATRIX_ROWS_3X4), this->count, flags,
                                      nullptr);
        });
}

// ------------------------------------------------------------------------------------------------- orders and scales

TYPED_TEST(ConvertErrorTest, an_order_that_is_none)
{
    using T = TypeParam;
    using C = api<T>;
    for (int number : {12, 13, 15}) { // what fits the enumeration
        const auto order = static_cast<mw_euler_order>(number);
        this->expect(MW_ERROR_EULER_ORDER, [&] {
            return C::convert_motor_to_euler_each(this->xyz(this->first()), this->xyz(this->second()),
                                     this->const_motors(this->third()), this->count, order);
        });
        this->expect(MW_ERROR_EULER_ORDER, [&] {
            return C::convert_euler_to_motor_each(this->motors(this->third()), this->const_xyz(this->first()),
                                     this->const_xyz(this->second()), this->count, order);
        });
    }
}

// Zero, not finite, or so small that its reciprocal is not.
TYPED_TEST(ConvertErrorTest, scales_that_are_none)
{
    using T = TypeParam;
    using C = api<T>;
    using Limits = std::numeric_limits<T>;
    const auto motors = this->motors(this->second());
    const auto in = this->const_motors(this->first());
    for (T lambda :
         {T(0), -T(0), Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::denorm_min()}) {
        this->expect(MW_ERROR_SCALE, [&] { return C::convert_motor_to_rotor_each(motors, in, this->count, lambda); });
        this->expect(MW_ERROR_SCALE, [&] { return C::convert_rotor_to_motor_each(motors, in, this->count, lambda); });
    }
    for (T lambda : {Limits::min(), T(-2), T(1e30)}) {
        EXPECT_EQ(C::convert_motor_to_rotor_each(motors, in, this->count, lambda), MW_OK) << lambda;
        EXPECT_EQ(C::convert_rotor_to_motor_each(motors, in, this->count, lambda), MW_OK) << lambda;
    }
}

// ----------------------------------------------------------------------------------------------------------- nothing

TYPED_TEST(ConvertErrorTest, a_count_of_0_takes_null_pointers)
{
    using T = TypeParam;
    using C = api<T>;
    const typename api<T>::motors motors{};
    const typename api<T>::const_motors const_motors{};
    const typename api<T>::xyz xyz{};
    const typename api<T>::const_xyz const_xyz{};
    const typename C::xyzw xyzw{};
    const typename C::const_xyzw const_xyzw{};
    EXPECT_EQ(C::convert_motor_to_pose_each(xyzw, xyz, const_motors, 0), MW_OK);
    EXPECT_EQ(C::convert_pose_to_motor_each(motors, const_xyzw, const_xyz, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_dual_quaternion_each({}, const_motors, 0), MW_OK);
    EXPECT_EQ(C::convert_dual_quaternion_to_motor_each(motors, {}, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_axis_angle_each(xyzw, xyz, const_motors, 0), MW_OK);
    EXPECT_EQ(C::convert_axis_angle_to_motor_each(motors, const_xyzw, const_xyz, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_euler_each(xyz, xyz, const_motors, 0, MW_EULER_XYZ), MW_OK);
    EXPECT_EQ(C::convert_euler_to_motor_each(motors, const_xyz, const_xyz, 0, MW_EULER_ZYZ), MW_OK);
    EXPECT_EQ(C::convert_translation_to_motor_each(motors, const_xyz, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_translation_each(xyz, const_motors, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_screw_each({}, const_motors, 0), MW_OK);
    EXPECT_EQ(C::convert_screw_to_motor_each(motors, {}, 0), MW_OK);
    EXPECT_EQ(C::convert_motor_to_rotor_each(motors, const_motors, 0, T(1)), MW_OK);
    EXPECT_EQ(C::convert_rotor_to_motor_each(motors, const_motors, 0, T(1)), MW_OK);
    for (mw_matrix_layout layout : all_matrix_layouts) {
        EXPECT_EQ(C::convert_motor_to_matrix_each({nullptr, 0, layout}, const_motors, 0), MW_OK);
        for (unsigned flags : all_matrix_flags)
            EXPECT_EQ(C::convert_matrix_to_motor_each(motors, {nullptr, 0, layout}, 0, flags, nullptr), MW_OK);
        std::size_t bad = 7;
        T deviation = 7;
        EXPECT_EQ(C::check_matrices({nullptr, 0, layout}, 0, T(0), &bad, &deviation), MW_OK);
        EXPECT_EQ(bad, 7u);
        EXPECT_EQ(deviation, T(0));  // of none the largest is 0
    }
}

}  // namespace
}  // namespace motorway::testing
