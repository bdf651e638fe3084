// Motions as benchmarks: sampled, moving a mesh, and compiled.
#pragma once

#include "api.h"
#include "kernels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace motorway::bench {

// Of the kernels that motions are made of.
struct motion_operations {
    std::size_t product, exp, slerp, point;
};

// sample_<kind>_<pairing>, in which `one` is one motion at sorted parameters, `one_random` at random ones, `each`
// many motions, each at a parameter of its own, and `each_shared` at one for all; sample_<kind>_twist_<pairing>, with
// velocities; apply_point_motion; and compile_<kind>.
std::vector<kernel_row> motion_rows(const motion_operations &operations);

// Of `controls` controls: those of the ends once for each degree, the others equally far apart between.
template <class T> std::vector<T> motion_knots(std::size_t controls)
{
    std::vector<T> knots(motion_degree, T(0));
    const std::size_t spans = controls - motion_degree;
    for (std::size_t i = 1; i < spans; ++i)
        knots.push_back(static_cast<T>(i) / static_cast<T>(spans));
    knots.insert(knots.end(), motion_degree, T(1));
    return knots;
}

// The frames of a motion on a mesh.
template <class T> std::vector<T> frame_parameters()
{
    std::vector<T> parameters;
    for (std::size_t frame = 0; frame < mesh_frames; ++frame)
        parameters.push_back(static_cast<T>(frame) / static_cast<T>(mesh_frames - 1));
    return parameters;
}

// A compiled motion in memory of its own, which does not move.
template <class T> class motion_memory {
public:
    using motion = typename api<T>::motion;

    explicit motion_memory(const motion &described)
    {
        std::size_t size = 0;
        require(api<T>::motion_size(&size, &described, nullptr));
        memory_.resize((size + sizeof memory_[0] - 1) / sizeof memory_[0]);
        compile(described);
    }
    void compile(const motion &described)
    {
        require(api<T>::compile_motion(&compiled_, memory_.data(), memory_.size() * sizeof memory_[0], &described,
                                       MW_DEFAULT, nullptr));
    }
    const typename api<T>::compiled_motion *get() const { return compiled_; }

private:
    std::vector<std::uint64_t> memory_;
    const typename api<T>::compiled_motion *compiled_ = nullptr;
};

// Those of a problem.
template <class T>
std::shared_ptr<motion_memory<T>> compile_motions(mw_motion_kind kind, const problem<T> &p, std::size_t motion_count);

} // namespace motorway::bench
