// All functions that are fuzzed, a file a family.
#ifndef MOTORWAY_TESTS_FUZZ_FAMILIES_H
#define MOTORWAY_TESTS_FUZZ_FAMILIES_H

#include "function.h"

namespace motorway::fuzz {

void add_exponentials(Functions &functions);
void add_products(Functions &functions);
void add_interpolations(Functions &functions);
void add_applications(Functions &functions);
void add_poses(Functions &functions);
void add_angles(Functions &functions);
void add_singles(Functions &functions);
void add_motions(Functions &functions);

inline Functions all_functions()
{
    Functions functions;
    add_exponentials(functions);
    add_products(functions);
    add_applications(functions);
    add_interpolations(functions);
    add_poses(functions);
    add_angles(functions);
    add_singles(functions);
    add_motions(functions);
    return functions;
}

}  // namespace motorway::fuzz

#endif
