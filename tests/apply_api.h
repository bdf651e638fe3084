// The apply functions of the C API as a table: a row an operand, expanded from MW_OPERANDS, and one for the mixed
// precision. All take one set of arguments, of which each pairing uses its own, so that a test says something of
// every operand and pairing at once.
#ifndef MOTORWAY_TESTS_APPLY_API_H
#define MOTORWAY_TESTS_APPLY_API_H

#include <array>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "api.h"
#include "subject.h"

namespace motorway::testing {

enum class Moved { point, direction, tangent, vertex, vector, line, motor, bivector };
enum class Pairing { one, each, indexed, indexed_checked, grid };

constexpr Pairing all_pairings[] = {Pairing::one, Pairing::each, Pairing::indexed, Pairing::indexed_checked,
                                    Pairing::grid};

inline const char *name_of(Pairing pairing)
{
    static const char *const names[] = {"one", "each", "indexed", "indexed_checked", "grid"};
    return names[static_cast<int>(pairing)];
}

template <class T>
struct ApplyCall {
    View<T> out, in;
    const void *motor = nullptr;  // of one; the palette of indexed
    std::size_t motor_count = 0;  // in the palette, or of a grid
    View<T> motors;               // of each and grid; those of mixed functions point to doubles
    mw_indices indices{nullptr, 0, MW_INDEX_U8};
    std::size_t row_stride = 0;
    const mw_shift *shift = nullptr;  // of mixed functions
    std::size_t count = 0;
    unsigned flags = MW_DEFAULT;
    std::size_t *first_bad = nullptr;
    std::size_t begin = 0;  // every view of elements is taken from this one on, by the API's own _from
};

template <class T>
struct ApplyFunctions {
    using Function = mw_status (*)(const ApplyCall<T> &);

    const char *operand, *precision;
    Moved moved;
    Operand views;
    std::size_t motor_scalar;                             // bytes a component of the motors
    Function one, each, indexed, indexed_checked, grid;

    bool is_mixed() const { return motor_scalar != sizeof(T); }
    std::size_t components() const { return components_of(views); }
    std::size_t motor_size() const { return 8 * motor_scalar; }

    std::string name(Pairing pairing) const
    {
        return std::string("apply_") + operand + "_" + name_of(pairing) + "_" + precision;
    }

    mw_status run(Pairing pairing, const ApplyCall<T> &call) const
    {
        const Function functions[] = {one, each, indexed, indexed_checked, grid};
        return functions[static_cast<int>(pairing)](call);
    }
};

template <class V>
constexpr bool is_vertices = std::is_same_v<V, mw_vertices_f32> || std::is_same_v<V, mw_const_vertices_f32> ||
                             std::is_same_v<V, mw_vertices_f64> || std::is_same_v<V, mw_const_vertices_f64>;

template <class V, class T, std::size_t... k>
V api_view(const View<T> &view, std::index_sequence<k...>)
{
    return {view.component[k]..., view.stride};
}

// A view of the API: its pointers are the first things in it, and then comes the stride. A view that a call has no
// use for is empty.
template <class V, class T>
V api_view(const View<T> &view)
{
    if (view.component.empty())
        return V{};
    if constexpr (is_vertices<V>) {
        const auto &c = view.component;
        return {{c[0], c[1], c[2], view.stride}, {c[3], c[4], c[5], view.stride}};
    } else {
        return api_view<V>(view, std::make_index_sequence<sizeof(V) / sizeof(void *) - 1>());
    }
}

template <class T>
std::vector<ApplyFunctions<T>> apply_functions();

#define MOTORWAY_TEST_OUT(views, P) mw_##views##_##P##_from(api_view<mw_##views##_##P>(c.out), c.begin)
#define MOTORWAY_TEST_IN(views, P) mw_const_##views##_##P##_from(api_view<mw_const_##views##_##P>(c.in), c.begin)
#define MOTORWAY_TEST_MOTOR(P) static_cast<const mw_motor_##P *>(c.motor)
#define MOTORWAY_TEST_MOTORS(P) api_view<mw_const_motors_##P>(c.motors.template as<scalar_##P>())
#define MOTORWAY_TEST_MOTORS_FROM(P) mw_const_motors_##P##_from(MOTORWAY_TEST_MOTORS(P), c.begin)
#define MOTORWAY_TEST_INDICES mw_indices_from(c.indices, c.begin)

#define MOTORWAY_TEST_OPERAND(operand, views, P)                                                                     \
    {#operand, #P, Moved::operand, Operand::views, sizeof(scalar_##P),                                               \
     [](const ApplyCall<scalar_##P> &c) {                                                                            \
         return api<scalar_##P>::apply_##operand##_one(MOTORWAY_TEST_OUT(views, P), MOTORWAY_TEST_MOTOR(P),          \
                                             MOTORWAY_TEST_IN(views, P), c.count, c.flags);                          \
     },                                                                                                              \
     [](const ApplyCall<scalar_##P> &c) {                                                                            \
         return api<scalar_##P>::apply_##operand##_each(MOTORWAY_TEST_OUT(views, P), MOTORWAY_TEST_MOTORS_FROM(P),   \
                                              MOTORWAY_TEST_IN(views, P), c.count, c.flags);                         \
     },                                                                                                              \
     [](const ApplyCall<scalar_##P> &c) {                                                                            \
         return api<scalar_##P>::apply_##operand##_indexed(MOTORWAY_TEST_OUT(views, P), MOTORWAY_TEST_MOTOR(P), c.motor_count, \
                                                 MOTORWAY_TEST_INDICES, MOTORWAY_TEST_IN(views, P), c.count,         \
                                                 c.flags);                                                           \
     },                                                                                                              \
     [](const ApplyCall<scalar_##P> &c) {                                                                            \
         return api<scalar_##P>::apply_##operand##_indexed_checked(                                                  \
             MOTORWAY_TEST_OUT(views, P), MOTORWAY_TEST_MOTOR(P), c.motor_count, MOTORWAY_TEST_INDICES,              \
             MOTORWAY_TEST_IN(views, P), c.count, c.flags, c.first_bad);                                             \
     },                                                                                                              \
     [](const ApplyCall<scalar_##P> &c) {                                                                            \
         return api<scalar_##P>::apply_##operand##_grid(MOTORWAY_TEST_OUT(views, P), c.row_stride, MOTORWAY_TEST_MOTORS(P), \
                                              c.motor_count, MOTORWAY_TEST_IN(views, P), c.count, c.flags);          \
     }},

template <>
inline std::vector<ApplyFunctions<double>> apply_functions()
{
    return {MW_OPERANDS(MOTORWAY_TEST_OPERAND, f64)};
}

// The last row is of points under motors of double.
template <>
inline std::vector<ApplyFunctions<float>> apply_functions()
{
    using Call = ApplyCall<float>;
    return {
        MW_OPERANDS(MOTORWAY_TEST_OPERAND, f32)
        {"point", "mixed", Moved::point, Operand::xyz, sizeof(double),
         [](const Call &c) {
             return api<mixed>::apply_point_one(MOTORWAY_TEST_OUT(xyz, f32), MOTORWAY_TEST_MOTOR(f64), c.shift,
                                             MOTORWAY_TEST_IN(xyz, f32), c.count, c.flags);
         },
         [](const Call &c) {
             return api<mixed>::apply_point_each(MOTORWAY_TEST_OUT(xyz, f32), MOTORWAY_TEST_MOTORS_FROM(f64), c.shift,
                                              MOTORWAY_TEST_IN(xyz, f32), c.count, c.flags);
         },
         [](const Call &c) {
             return api<mixed>::apply_point_indexed(MOTORWAY_TEST_OUT(xyz, f32), MOTORWAY_TEST_MOTOR(f64), c.motor_count,
                                                 MOTORWAY_TEST_INDICES, c.shift, MOTORWAY_TEST_IN(xyz, f32), c.count,
                                                 c.flags);
         },
         [](const Call &c) {
             return api<mixed>::apply_point_indexed_checked(MOTORWAY_TEST_OUT(xyz, f32), MOTORWAY_TEST_MOTOR(f64),
                                                         c.motor_count, MOTORWAY_TEST_INDICES, c.shift,
                                                         MOTORWAY_TEST_IN(xyz, f32), c.count, c.flags, c.first_bad);
         },
         [](const Call &c) {
             return api<mixed>::apply_point_grid(MOTORWAY_TEST_OUT(xyz, f32), c.row_stride, MOTORWAY_TEST_MOTORS(f64),
                                              c.motor_count, c.shift, MOTORWAY_TEST_IN(xyz, f32), c.count, c.flags);
         }},
    };
}

#undef MOTORWAY_TEST_OUT
#undef MOTORWAY_TEST_IN
#undef MOTORWAY_TEST_MOTOR
#undef MOTORWAY_TEST_MOTORS
#undef MOTORWAY_TEST_MOTORS_FROM
#undef MOTORWAY_TEST_INDICES
#undef MOTORWAY_TEST_OPERAND

// The row of one operand, or the mixed one.
template <class T>
ApplyFunctions<T> apply_functions_of(Moved moved, bool mixed = false)
{
    for (const ApplyFunctions<T> &functions : apply_functions<T>())
        if (functions.moved == moved && functions.is_mixed() == mixed)
            return functions;
    throw std::invalid_argument("no such function");
}

}  // namespace motorway::testing

#endif
