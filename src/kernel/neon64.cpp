#define MOTORWAY_ISA_neon64
#include "unit.h"
