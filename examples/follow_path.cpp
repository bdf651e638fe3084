// Move points along a path through four poses, and say where the first of them is and how fast.
#include <motorway.hpp>

#include <cstdio>
#include <cstdlib>
#include <vector>

void check(mw_status status)
{
    if (status != MW_OK)
        std::exit((std::puts(mw_status_text(status)), 1));
}

// Turned by an angle about the z axis, and then moved.
motorway::motor<float> pose(float angle, const float (&offset)[3])
{
    using namespace motorway;
    motor<float> turn, move, both;
    check(rotation(turn, {0, 0, 1}, angle));
    check(translation(move, offset));
    check(compose_motor_each(aos(&both), aos(&turn), aos(&move), 1));
    return both;
}

int main()
{
    using namespace motorway;
    const std::vector<motor<float>> poses = {pose(0, {0, 0, 0}), pose(1, {2, 0, 1}), pose(2, {4, 2, 1}),
                                             pose(3, {4, 4, 0})};
    motion<float> path = {};
    path.kind = MW_MOTION_GENERATOR_KEYS; // passes through the poses, at 0, 1, 2 and 3
    path.controls = poses.data();
    path.control_count = poses.size();
    path.base = &poses[1];

    size_t size;
    check(motion_size(size, path));
    std::vector<double> memory(size / sizeof(double) + 1);
    const compiled_motion<float> *compiled;
    check(compile_motion(compiled, memory.data(), memory.size() * sizeof(double), path));

    const std::vector<float> times = {0, 0.5f, 1, 1.5f, 2, 2.5f, 3}, points = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    std::vector<float> frames(times.size() * points.size()); // a row of points for each time
    check(apply_point_motion(aos(frames.data()), points.size() * sizeof(float), compiled, times.data(), times.size(),
                             aos(points.data()), points.size() / 3));

    std::vector<motor<float>> at(times.size());
    std::vector<float> twists(6 * times.size());
    check(sample_motion_twist_one(aos(at.data()), bivectors_aos(twists.data()), compiled, times.data(), times.size()));
    for (size_t i = 0; i < times.size(); ++i) {
        const float *const place = &frames[points.size() * i], *const b = &twists[6 * i];
        float velocity[3];
        check(twist_velocity(velocity, {b[0], b[1], b[2], b[3], b[4], b[5]}, {place[0], place[1], place[2]}));
        std::printf("t = %.1f: at %5.2f %5.2f %5.2f, moving by %5.2f %5.2f %5.2f\n", times[i], place[0], place[1],
                    place[2], velocity[0], velocity[1], velocity[2]);
    }
}
