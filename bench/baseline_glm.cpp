// GLM: mat4 for one motion, quat and vec3 for one motion a point.
#include "baseline.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace motorway::bench {
namespace {

template <class T> using vec3 = glm::vec<3, T, glm::defaultp>;
template <class T> using vec4 = glm::vec<4, T, glm::defaultp>;
template <class T> using mat3 = glm::mat<3, 3, T, glm::defaultp>;
template <class T> using mat4 = glm::mat<4, 4, T, glm::defaultp>;
template <class T> using quaternion = glm::qua<T, glm::defaultp>;

template <class T> struct quaternion_and_translation {
    quaternion<T> rotation;
    vec3<T> translation;
};

template <class T> mat4<T> matrix_of(const rigid &r)
{
    mat4<T> matrix(T(1));
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            matrix[column][row] = static_cast<T>(r.rotation[row][column]);
        matrix[3][row] = static_cast<T>(r.translation[row]);
    }
    return matrix;
}

template <class T> quaternion_and_translation<T> quaternion_and_translation_of(const rigid &r)
{
    const glm::dquat q(r.quaternion[0], r.quaternion[1], r.quaternion[2], r.quaternion[3]);
    return {quaternion<T>(q), vec3<T>(r.translation[0], r.translation[1], r.translation[2])};
}

template <class T> auto point_map(const mat4<T> &motion)
{
    return [motion](std::size_t, const vec3<T> &v) { return vec3<T>(motion * vec4<T>(v, T(1))); };
}

template <class T> auto direction_map(const mat4<T> &motion)
{
    return [rotation = mat3<T>(motion)](std::size_t, const vec3<T> &v) { return rotation * v; };
}

template <class T> work move_by_matrices(const problem<T> &p)
{
    using V = vec3<T>;
    if (p.fixed.empty())
        return {};
    const auto motions = convert_motors(p, matrix_of<T>);
    if (p.kernel == "apply_point_one")
        return move_points<V>(p, point_map(motions->front()));
    if (p.kernel == "apply_direction_one")
        return move_points<V>(p, direction_map(motions->front()));
    if (p.kernel == "apply_vertex_one")
        return move_vertices<V>(p, point_map(motions->front()), direction_map(motions->front()));
    if (p.kernel == "apply_point_grid")
        return move_poses<V>(p, [=](std::size_t m) { return point_map((*motions)[m]); });
    if (p.kernel == "apply_point_indexed")
        return move_points<V>(p, [=, index = p.indices.data()](std::size_t i, const V &v) {
            return V((*motions)[index[i]] * vec4<T>(v, T(1)));
        });
    return {};
}

} // namespace

template <class T> work bind_glm(const problem<T> &p)
{
    using V = vec3<T>;
    if (p.kernel == "apply_point_each" || p.kernel == "apply_direction_each") {
        const auto motions = convert_motors(p, quaternion_and_translation_of<T>);
        if (p.kernel == "apply_point_each")
            return move_points<V>(p, [=](std::size_t i, const V &v) {
                return (*motions)[i].rotation * v + (*motions)[i].translation;
            });
        return move_points<V>(p, [=](std::size_t i, const V &v) { return (*motions)[i].rotation * v; });
    }
    return move_by_matrices(p);
}

template work bind_glm(const problem<float> &);
template work bind_glm(const problem<double> &);

} // namespace motorway::bench
