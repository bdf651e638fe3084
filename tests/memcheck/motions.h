// What is called one motor or one motion at a time, and what checks a batch.
#ifndef MOTORWAY_TESTS_MEMCHECK_MOTIONS_H
#define MOTORWAY_TESTS_MEMCHECK_MOTIONS_H

namespace motorway::memcheck {

void check_single_motors();
void check_motions();

}  // namespace motorway::memcheck

#endif
