#define MOTORWAY_ISA_sse2
#include "unit.h"
