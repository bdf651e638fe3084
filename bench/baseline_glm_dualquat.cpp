// GLM's dual quaternions. Its normalize divides both parts by the length of the real one, which leaves the dual part
// wrong, and so has no place beside normalize_motor_each.
#include "baseline.h"

#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtx/dual_quaternion.hpp>

namespace motorway::bench {
namespace {

template <class T> using dual_quaternion = glm::tdualquat<T, glm::defaultp>;
template <class T> using quaternion = glm::qua<T, glm::defaultp>;

template <class T> dual_quaternion<T> convert(const std::array<double, 8> &motor)
{
    std::array<T, 8> q;
    const auto exact = dual_quaternion_of(motor);
    for (int k = 0; k < 8; ++k)
        q[k] = static_cast<T>(exact[k]);
    return {quaternion<T>(q[0], q[1], q[2], q[3]), quaternion<T>(q[4], q[5], q[6], q[7])};
}

template <class T> auto convert_all(const array<T> &motors, std::size_t count)
{
    auto converted = std::make_shared<std::vector<dual_quaternion<T>>>();
    for (std::size_t i = 0; i < count; ++i)
        converted->push_back(convert<T>(motor_at(motors, i)));
    return converted;
}

template <class T> void write_motor(const array<T> &to, std::size_t i, const dual_quaternion<T> &q)
{
    const auto motor = motor_of<T>({q.real.w, q.real.x, q.real.y, q.real.z, q.dual.w, q.dual.x, q.dual.y, q.dual.z});
    for (std::size_t k = 0; k < 8; ++k)
        to.at(k, i) = motor[k];
}

// Arrays of dual quaternions, whatever the layout of the motors: GLM has no other.
template <class T> work compose(const problem<T> &p)
{
    const auto first = convert_all(p.in[0], p.count), then = convert_all(p.in[1], p.count);
    const auto out = std::make_shared<std::vector<dual_quaternion<T>>>(p.count);
    return make_work(
        [=, count = p.count] {
            const auto *const a = then->data(), *const b = first->data();
            auto *const c = out->data();
            for (std::size_t i = 0; i < count; ++i)
                c[i] = a[i] * b[i];
        },
        [=, &p] {
            for (std::size_t i = 0; i < p.count; ++i)
                write_motor(p.out[0], i, (*out)[i]);
        });
}

} // namespace

template <class T> work bind_glm_dualquat(const problem<T> &p)
{
    using V = glm::vec<3, T, glm::defaultp>;
    if (p.kernel == "apply_point_one")
        return move_points<V>(p, [q = convert<T>(fixed_motor(p))](std::size_t, const V &v) { return q * v; });
    if (p.kernel == "apply_point_each")
        return move_points<V>(p, [q = convert_all(*p.motors, p.count)](std::size_t i, const V &v) {
            return (*q)[i] * v;
        });
    if (p.kernel == "apply_point_indexed") {
        const auto palette = std::make_shared<std::vector<dual_quaternion<T>>>();
        for (std::size_t k = 0; k < shared_motors; ++k)
            palette->push_back(convert<T>(fixed_motor(p, k)));
        return move_points<V>(p, [=, index = p.indices.data()](std::size_t i, const V &v) {
            return (*palette)[index[i]] * v;
        });
    }
    if (p.kernel == "compose_motor_each" && p.kind == layout::packed)
        return compose(p);
    return {};
}

template work bind_glm_dualquat(const problem<float> &);
template work bind_glm_dualquat(const problem<double> &);

} // namespace motorway::bench
