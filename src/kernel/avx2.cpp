#define MOTORWAY_ISA_avx2
#include "unit.h"
