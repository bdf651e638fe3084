#define MOTORWAY_ISA_scalar
#include "unit.h"
