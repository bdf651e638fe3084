// Pose a mesh that lies in an interleaved vertex buffer, as engines keep it.
#include <motorway.hpp>

#include <cstdio>
#include <cstdlib>
#include <vector>

struct vertex {
    float position[3], normal[3], uv[2];
};

void check(mw_status status)
{
    if (status != MW_OK)
        std::exit((std::puts(mw_status_text(status)), 1));
}

int main()
{
    const std::vector<vertex> mesh = {{{1, 0, 0}, {0, 0, 1}, {0, 0}}, {{2, 0, 0}, {1, 0, 0}, {1, 0}}};
    std::vector<vertex> posed = mesh;

    // A quarter turn about the z axis through (1, 0, 0), and then two up.
    using namespace motorway;
    motor<float> turn, lift, both;
    check(rotation(turn, {0, 0, 1}, 1.57079633f, {1, 0, 0}));
    check(translation(lift, {0, 0, 2}));
    check(compose_motor_each(aos(&both), aos(&turn), aos(&lift), 1));

    const size_t stride = sizeof(vertex), count = mesh.size();
    check(apply_vertex_one(vertices_aos(posed[0].position, posed[0].normal, stride), both,
                           vertices_aos(mesh[0].position, mesh[0].normal, stride), count));

    for (const vertex &v : posed)
        std::printf("position %5.2f %5.2f %5.2f   normal %5.2f %5.2f %5.2f\n", v.position[0], v.position[1],
                    v.position[2], v.normal[0], v.normal[1], v.normal[2]);
}
