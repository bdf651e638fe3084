#define MOTORWAY_ISA_avx512
#include "unit.h"
