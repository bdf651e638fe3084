// Eigen: an isometry (a 4×4 matrix) for one motion, and a quaternion and a translation for one motion a point.
// Separate arrays are moved as arrays, which Eigen vectorises. It interpolates quaternions alone: beside whole motors
// that is half of the work.
#include "baseline.h"

#include <Eigen/Geometry>

namespace motorway::bench {
namespace {

template <class T> using isometry = Eigen::Transform<T, 3, Eigen::Isometry>;
template <class T> using vector3 = Eigen::Matrix<T, 3, 1>;

template <class T> struct quaternion_and_translation {
    Eigen::Quaternion<T> rotation;
    vector3<T> translation;
};

template <class T> isometry<T> isometry_of(const rigid &r)
{
    isometry<T> result = isometry<T>::Identity();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            result.linear()(row, column) = static_cast<T>(r.rotation[row][column]);
        result.translation()(row) = static_cast<T>(r.translation[row]);
    }
    return result;
}

template <class T> quaternion_and_translation<T> quaternion_and_translation_of(const rigid &r)
{
    const Eigen::Quaterniond q(r.quaternion[0], r.quaternion[1], r.quaternion[2], r.quaternion[3]);
    return {q.cast<T>(), Eigen::Map<const Eigen::Vector3d>(r.translation).template cast<T>()};
}

template <class T> work move_arrays(const problem<T> &p, const isometry<T> &motion)
{
    using input = Eigen::Map<const Eigen::Array<T, Eigen::Dynamic, 1>, Eigen::Aligned64>;
    using output = Eigen::Map<Eigen::Array<T, Eigen::Dynamic, 1>, Eigen::Aligned64>;
    const auto in = p.in[0].component(), out = p.out[0].component();
    const auto size = static_cast<Eigen::Index>(p.count);
    return make_work([=] {
        const input x(in[0], size), y(in[1], size), z(in[2], size);
        for (int row = 0; row < 3; ++row)
            output(out[row], size) =
                motion(row, 0) * x + motion(row, 1) * y + motion(row, 2) * z + motion(row, 3);
    });
}

template <class T> auto point_map(const isometry<T> &motion)
{
    return [motion](std::size_t, const vector3<T> &v) -> vector3<T> { return motion * v; };
}

template <class T> auto direction_map(const isometry<T> &motion)
{
    return [rotation = Eigen::Matrix<T, 3, 3>(motion.linear())](std::size_t, const vector3<T> &v) -> vector3<T> {
        return rotation * v;
    };
}

template <class T> work move_by_isometries(const problem<T> &p)
{
    using V = vector3<T>;
    if (p.fixed.empty())
        return {};
    const auto motions = convert_motors(p, isometry_of<T>);
    if (p.kernel == "apply_point_one")
        return p.kind == layout::soa ? move_arrays(p, motions->front())
                                     : move_points<V>(p, point_map(motions->front()));
    if (p.kernel == "apply_direction_one") {
        motions->front().translation().setZero();
        return p.kind == layout::soa ? move_arrays(p, motions->front())
                                     : move_points<V>(p, direction_map(motions->front()));
    }
    if (p.kernel == "apply_vertex_one")
        return move_vertices<V>(p, point_map(motions->front()), direction_map(motions->front()));
    if (p.kernel == "apply_point_grid")
        return move_poses<V>(p, [=](std::size_t m) { return point_map((*motions)[m]); });
    if (p.kernel == "apply_point_indexed")
        return move_points<V>(p, [=, index = p.indices.data()](std::size_t i, const V &v) -> V {
            return (*motions)[index[i]] * v;
        });
    return {};
}

template <class T> auto quaternions_of(const array<T> &motors, std::size_t count)
{
    auto converted = std::make_shared<std::vector<Eigen::Quaternion<T>>>();
    for (std::size_t i = 0; i < count; ++i)
        converted->push_back(quaternion_and_translation_of<T>(rigid_of(motor_at(motors, i))).rotation);
    return converted;
}

template <class T> work interpolate_rotations(const problem<T> &p)
{
    const auto first = quaternions_of(p.in[0], p.count), second = quaternions_of(p.in[1], p.count);
    const auto out = std::make_shared<std::vector<Eigen::Quaternion<T>>>(p.count);
    work todo = make_work(
        [=, parameters = p.in[2].component()[0], count = p.count] {
            const auto *const a = first->data(), *const b = second->data();
            auto *const c = out->data();
            for (std::size_t i = 0; i < count; ++i)
                c[i] = a[i].slerp(parameters[i], b[i]);
        },
        [=, &p] {
            for (std::size_t i = 0; i < p.count; ++i) {
                const Eigen::Quaternion<T> &q = (*out)[i];
                const auto motor = motor_of<T>({q.w(), q.x(), q.y(), q.z(), 0, 0, 0, 0});
                for (std::size_t k = 0; k < 4; ++k)
                    p.out[0].at(k, i) = motor[k];
            }
        });
    todo.components = 4;
    return todo;
}

} // namespace

template <class T> work bind_eigen(const problem<T> &p)
{
    if (p.kernel == "apply_point_each" || p.kernel == "apply_direction_each") {
        const auto motions = convert_motors(p, quaternion_and_translation_of<T>);
        if (p.kernel == "apply_point_each")
            return move_points<vector3<T>>(p, [=](std::size_t i, const vector3<T> &v) -> vector3<T> {
                const auto &motion = (*motions)[i];
                return motion.rotation * v + motion.translation;
            });
        return move_points<vector3<T>>(p, [=](std::size_t i, const vector3<T> &v) -> vector3<T> {
            return (*motions)[i].rotation * v;
        });
    }
    if (p.kernel == "slerp_motor_each" && p.kind == layout::packed)
        return interpolate_rotations(p);
    return move_by_isometries(p);
}

template work bind_eigen(const problem<float> &);
template work bind_eigen(const problem<double> &);

} // namespace motorway::bench
