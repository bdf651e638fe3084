// The kernels of generated/kernel_list.inc as tests: every row becomes its subjects, in both precisions. A row whose
// subjects nobody has written (subjects_of_<verb>_<operand>_<pairing>) does not compile.
#ifndef MOTORWAY_TESTS_KERNEL_LIST_H
#define MOTORWAY_TESTS_KERNEL_LIST_H

#include <ostream>
#include <string>
#include <vector>

#include "apply_tester.h"
#include "blend_tester.h"
#include "compose_tester.h"
#include "convert_tester.h"
#include "exponential_tester.h"
#include "inverse_tester.h"
#include "nlerp_tester.h"
#include "normalize_tester.h"
#include "power_tester.h"
#include "ratio_tester.h"
#include "reverse_tester.h"
#include "slerp_tester.h"
#include "subject.h"

namespace motorway::testing {

enum class Variant { any, unit, mixed };  // unit: for MW_UNIT_MOTORS

struct KernelRow {
    std::string name;
    Variant variant;
    int inputs, outputs, operations, divisions;
    Subjects<float> (*subjects_f32)();
    Subjects<double> (*subjects_f64)();

    // As far as tests are concerned a mixed kernel is one of floats.
    std::vector<std::string> precisions() const
    {
        return variant == Variant::mixed ? std::vector<std::string>{"mixed"} : std::vector<std::string>{"f32", "f64"};
    }

    template <class T>
    Subjects<T> subjects() const
    {
        if constexpr (sizeof(T) == sizeof(float))
            return subjects_f32();
        else
            return subjects_f64();
    }
};

inline void PrintTo(const KernelRow &row, std::ostream *out) { *out << row.name; }

inline const std::vector<KernelRow> &kernel_rows()
{
#define MOTORWAY_TEST_ROW(name, variant, inputs, outputs, operations, divisions)                                     \
    {#name, Variant::variant, inputs, outputs, operations, divisions, subjects_of_##name<float>,                     \
     subjects_of_##name<double>},
#define MOTORWAY_KERNEL(verb, operand, pairing, inputs, outputs, operations, divisions)                              \
    MOTORWAY_TEST_ROW(verb##_##operand##_##pairing, any, inputs, outputs, operations, divisions)
#define MOTORWAY_KERNEL_UNIT(verb, operand, pairing, inputs, outputs, operations, divisions)                         \
    MOTORWAY_TEST_ROW(verb##_##operand##_##pairing##_unit, unit, inputs, outputs, operations, divisions)
#define MOTORWAY_KERNEL_MIXED(verb, operand, pairing, inputs, outputs, operations, divisions)                        \
    {#verb "_" #operand "_" #pairing "_mixed", Variant::mixed, inputs, outputs, operations, divisions,               \
     subjects_of_##verb##_##operand##_##pairing##_mixed, [] { return Subjects<double>(); }},
    static const std::vector<KernelRow> rows = {
#include "../generated/kernel_list.inc"
    };
#undef MOTORWAY_TEST_ROW
    return rows;
}

}  // namespace motorway::testing

#endif
