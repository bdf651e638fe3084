// Angles of any size, to the last finite one, less whole turns: with as many bits of 1/(2π) as that takes (Payne and
// Hanek, 1983). Compiled for every CPU, and called by kernels of all instruction sets for the rare lane whose angle is
// too large for their own reduction; so this header has declarations alone.
#pragma once

namespace motorway {

// In [-π, π], rounded once; of the same sine and cosine. The angle is finite.
double without_turns(double angle);

// Makes of the bivector b12 b13 b23 b1i b2i b3i one of the same exponential that turns by no more than a full turn,
// |b| <= π: the way along the axis stays, what is around it becomes less with the angle. The first three are finite, and
// not all of them 0.
void take_turns_off(double *bivector);

// quadrant · π/2 + high + low, with |high| <= π/4; the quadrant is right but for multiples of 4.
struct quadrant_angle {
    int quadrant;
    double high, low;
};
quadrant_angle in_quadrant(double angle);

} // namespace motorway
