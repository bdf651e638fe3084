// The library itself on a mesh, under the poses of a motion that are made beforehand: apply_point_motion if samples
// cost nothing.
#include "baseline.h"
#include "motions.h"

#include <memory>

namespace motorway::bench {

template <class T> std::shared_ptr<std::vector<T>> make_poses(const problem<T> &p)
{
    using motor = typename api<T>::motor;
    const auto motion = compile_motions(MW_MOTION_ADDITIVE, p, 1);
    const std::vector<T> parameters = frame_parameters<T>();
    auto poses = std::make_shared<std::vector<T>>(components_of(operand::motor) * mesh_frames);
    const auto out = api<T>::motors_aos(reinterpret_cast<motor *>(poses->data()), sizeof(motor));
    require(api<T>::sample_motion_one(out, motion->get(), 0, parameters.data(), parameters.size(), MW_DEFAULT));
    return poses;
}

template <class T> work bind_poses(const problem<T> &p)
{
    if (p.kernel != "apply_point_motion")
        return {};
    using functions = apply_functions<operand::point, T, T>;
    const bool columns = p.kind == layout::columns;
    const std::size_t step = p.out[0].stride();
    const auto in = view_of<typename functions::const_view>(p.in[0]);
    const auto out = view_of<typename functions::view>(p.out[0], columns ? mesh_frames * step : step);
    return make_work([=, poses = make_poses(p), count = p.count] {
        require(functions::grid(out, columns ? step : count * step, packed_motors<T>(poses->data()), mesh_frames, in,
                                count, MW_DEFAULT));
    });
}

template work bind_poses(const problem<float> &);
template work bind_poses(const problem<double> &);

} // namespace motorway::bench
