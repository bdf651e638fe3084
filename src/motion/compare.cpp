// The largest distance between two motions.
#include "../scalar_math.h"
#include "evenly.h"
#include "sample.h"

namespace motorway {
namespace {

// Poses and points that are compared at once: their images stay in the first cache.
constexpr std::size_t pose_block = 8, point_block = 128;

// Some points, one array a component.
template <class T> struct places {
    T component[3][point_block];

    void copy(const view<const T, 3> &points, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c)
                __builtin_memcpy(&component[c][i], points.from(i).component[c], sizeof(T));
    }
};

// The public functions of both precisions under one name. They are called with what has been checked.
#define MOTORWAY_CALLS(P, T)                                                                                          \
    inline mw_motors_##P packed(mw_motor_##P *motors) { return mw_motors_##P##_aos(motors, sizeof *motors); }         \
    inline void apply(places<T> *images, const mw_motor_##P *poses, std::size_t pose_count, const places<T> &points,  \
                      std::size_t count)                                                                              \
    {                                                                                                                 \
        const auto &in = points.component;                                                                            \
        auto &out = images->component;                                                                                \
        const mw_xyz_##P to = mw_xyz_##P##_soa(out[0], out[1], out[2]);                                               \
        const mw_const_xyz_##P from = mw_const_xyz_##P##_soa(in[0], in[1], in[2]);                                    \
        const mw_const_motors_##P motors = mw_const_motors_##P##_aos(poses, sizeof *poses);                           \
        mw_apply_point_grid_views_##P(&to, sizeof *images, &motors, pose_count, &from, count, MW_DEFAULT);            \
    }
MOTORWAY_CALLS(f32, float)
MOTORWAY_CALLS(f64, double)
#undef MOTORWAY_CALLS

// Some samples of a motion, and the images of some points under each.
template <class T> struct samples {
    T parameters[pose_block];
    motor_of<T> poses[pose_block];
    places<T> images[pose_block];

    void make_poses(const compiled<T> &motion, std::size_t index, std::size_t begin, std::size_t count,
                    std::size_t sample_count)
    {
        for (std::size_t i = 0; i < count; ++i)
            parameters[i] = evenly_spaced(motion.begin(), motion.end(), begin + i, sample_count);
        motion_samples<T>(motion, motions_sampled::one, index, {parameters, sizeof(T)}, count, MW_DEFAULT)
            .sample(view_of(packed(poses)));
    }
};

// The number of the largest distance, if its square is larger than *square; else `count`. One that is NaN is not
// larger than any.
template <class T>
std::size_t find_larger(const places<T> &first, const places<T> &second, std::size_t count, double *square)
{
    double squares[point_block];
    for (std::size_t i = 0; i < count; ++i) {
        const double x = double(first.component[0][i]) - double(second.component[0][i]);
        const double y = double(first.component[1][i]) - double(second.component[1][i]);
        const double z = double(first.component[2][i]) - double(second.component[2][i]);
        squares[i] = x * x + y * y + z * z;
    }
    std::size_t largest = count;
    double so_far = *square;
    for (std::size_t i = 0; i < count; ++i)
        if (squares[i] > so_far)
            so_far = squares[i], largest = i;
    *square = so_far;
    return largest;
}

template <class T, class Distance>
mw_status compare_motions(Distance *largest, const typename c_types<T>::compiled *first, std::size_t first_index,
                          const typename c_types<T>::compiled *second, std::size_t second_index,
                          const view<const T, 3> &points, std::size_t count, std::size_t sample_count)
{
    if (!kernels())
        return MW_ERROR_ISA;
    const mw_status status = first_error(
        largest && first && second ? MW_OK : MW_ERROR_NULL,
        [&] { return count && sample_count ? check_view(points, count) : MW_OK; },
        [&] { return check_compiled<T>(first, first_index); },
        [&] { return check_compiled<T>(second, second_index); });
    if (status != MW_OK)
        return status;

    Distance found = {0, {compiled_of<T>(first).begin(), compiled_of<T>(second).begin()}, 0};
    samples<T> a, b;
    places<T> some;
    double square = 0;
    for (std::size_t sample = 0; sample < sample_count && count > 0; sample += pose_block) {
        const std::size_t poses = std::min(pose_block, sample_count - sample);
        a.make_poses(compiled_of<T>(first), first_index, sample, poses, sample_count);
        b.make_poses(compiled_of<T>(second), second_index, sample, poses, sample_count);
        for (std::size_t begin = 0; begin < count; begin += point_block) {
            const std::size_t number = std::min(point_block, count - begin);
            some.copy(points.from(begin), number);
            apply(a.images, a.poses, poses, some, number);
            apply(b.images, b.poses, poses, some, number);
            for (std::size_t pose = 0; pose < poses; ++pose) {
                const std::size_t point = find_larger(a.images[pose], b.images[pose], number, &square);
                if (point < number)
                    found = {0, {a.parameters[pose], b.parameters[pose]}, begin + point};
            }
        }
    }
    found.distance = static_cast<T>(square_root(square));
    *largest = found;
    return MW_OK;
}

} // namespace
} // namespace motorway

using namespace motorway;
#include "../../generated/calls/motion_compare.inc"
