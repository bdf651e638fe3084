// One function on one batch of inputs: what each instruction set makes of them.
#ifndef MOTORWAY_TESTS_FUZZ_ROUND_H
#define MOTORWAY_TESTS_FUZZ_ROUND_H

#include <cstdint>
#include <string>

#include "function.h"

namespace motorway::fuzz {

constexpr std::size_t most_bytes = most_elements * most_components * sizeof(double);

// Elements of the inputs and of the results, packed.
struct Batch {
    char inputs[most_inputs][most_bytes];
};
struct Results {
    char elements[most_bytes];
};

// Runs the function as its first way and packed, and then in other ways, ranges and layouts, in place or not, which
// must give the same bits. What did not is said in `fault`, and of which element.
struct Outcome {
    std::int64_t element = -1;
    char fault[240] = "";
};
Outcome run(const Function &function, const Batch &batch, std::size_t count, std::uint64_t seed, Results &results);

// The same bits, or both NaN.
bool same_number(const char *a, const char *b, std::size_t size);

}  // namespace motorway::fuzz

#endif
