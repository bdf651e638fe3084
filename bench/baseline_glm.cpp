// GLM: mat4 for one motion, quat and vec3 for one motion a point.
#include "baseline.h"

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace motorway::bench {
namespace {

template <class T> using vec3 = glm::vec<3, T, glm::defaultp>;
template <class T> using vec4 = glm::vec<4, T, glm::defaultp>;
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

} // namespace

template <class T> work bind_glm(const problem<T> &p)
{
    using V = vec3<T>;
    if (p.kernel == "apply_point_one")
        return move_points<V>(p, [m = matrix_of<T>(rigid_of(fixed_motor(p)))](std::size_t, const V &v) {
            return V(m * vec4<T>(v, T(1)));
        });
    if (p.kernel == "apply_direction_one")
        return move_points<V>(p, [m = glm::mat<3, 3, T, glm::defaultp>(matrix_of<T>(rigid_of(fixed_motor(p))))](
                                     std::size_t, const V &v) { return m * v; });
    if (p.kernel == "apply_point_each" || p.kernel == "apply_direction_each") {
        const auto motions = convert_motors(p.in[0], p.count, quaternion_and_translation_of<T>);
        if (p.kernel == "apply_point_each")
            return move_points<V>(p, [=](std::size_t i, const V &v) {
                return (*motions)[i].rotation * v + (*motions)[i].translation;
            });
        return move_points<V>(p, [=](std::size_t i, const V &v) { return (*motions)[i].rotation * v; });
    }
    return {};
}

template work bind_glm(const problem<float> &);
template work bind_glm(const problem<double> &);

} // namespace motorway::bench
