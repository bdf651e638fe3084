// cglm, which has f32 alone: mat4 for one motion, versor and vec3 for one motion a point.
#include "baseline.h"

#include <cglm/cglm.h>

namespace motorway::bench {
namespace {

struct vector3 {
    vec3 components;

    vector3() = default;
    vector3(float x, float y, float z) : components{x, y, z} {}
    float operator[](int k) const { return components[k]; }
    // cglm takes no const pointers
    float *data() const { return const_cast<float *>(components); }
};

struct matrix {
    mat4 columns;

    vec4 *data() const { return const_cast<vec4 *>(columns); }
};

struct versor_and_translation {
    versor rotation;
    vec3 translation;
};

matrix matrix_of(const rigid &r)
{
    matrix m;
    glm_mat4_identity(m.columns);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            m.columns[column][row] = static_cast<float>(r.rotation[row][column]);
        m.columns[3][row] = static_cast<float>(r.translation[row]);
    }
    return m;
}

versor_and_translation versor_and_translation_of(const rigid &r)
{
    versor_and_translation result;
    for (int k = 0; k < 3; ++k) {
        result.rotation[k] = static_cast<float>(r.quaternion[1 + k]);
        result.translation[k] = static_cast<float>(r.translation[k]);
    }
    result.rotation[3] = static_cast<float>(r.quaternion[0]);
    return result;
}

work move_by_one(const problem<float> &p, float last)
{
    return move_points<vector3>(p, [last, m = matrix_of(rigid_of(fixed_motor(p)))](std::size_t, const vector3 &v) {
        vector3 moved;
        glm_mat4_mulv3(m.data(), v.data(), last, moved.components);
        return moved;
    });
}

} // namespace

template <class T> work bind_cglm(const problem<T> &) { return {}; }

template <> work bind_cglm(const problem<float> &p)
{
    if (p.kernel == "apply_point_one")
        return move_by_one(p, 1);
    if (p.kernel == "apply_direction_one")
        return move_by_one(p, 0);
    if (p.kernel == "apply_point_each" || p.kernel == "apply_direction_each") {
        const auto motions = convert_motors(p, versor_and_translation_of);
        const bool point = p.kernel == "apply_point_each";
        if (point)
            return move_points<vector3>(p, [=](std::size_t i, const vector3 &v) {
                vector3 moved;
                glm_quat_rotatev((*motions)[i].rotation, v.data(), moved.components);
                glm_vec3_add(moved.components, (*motions)[i].translation, moved.components);
                return moved;
            });
        return move_points<vector3>(p, [=](std::size_t i, const vector3 &v) {
            vector3 moved;
            glm_quat_rotatev((*motions)[i].rotation, v.data(), moved.components);
            return moved;
        });
    }
    return {};
}

template work bind_cglm(const problem<double> &);

} // namespace motorway::bench
