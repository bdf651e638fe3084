// A function of the library, as the fuzzer sees it: what goes in, the ways to call it that must all give the same
// bits, and what is right.
#ifndef MOTORWAY_TESTS_FUZZ_FUNCTION_H
#define MOTORWAY_TESTS_FUZZ_FUNCTION_H

#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "motorway_views.h"
#include "random.h"
#include "verdict.h"

namespace motorway::fuzz {

constexpr std::size_t most_components = 16, most_inputs = 12, most_elements = 320;

// Elements of so many numbers, each of `size` bytes.
struct Stream {
    std::size_t components;
    std::size_t size;
    enum Kind {
        apart,     // components may lie anywhere
        adjacent,  // they are adjacent: matrices, palettes
        shared     // one element, adjacent, for the whole batch
    } kind = apart;
    unsigned unread = 0;  // a bit a component that is there and is not read
};

// Where the components of a stream are.
struct Place {
    std::array<char *, most_components> component{};
    std::size_t stride = 0;

    Place from(std::size_t begin) const
    {
        Place place = *this;
        for (char *&pointer : place.component)
            if (pointer)
                pointer += begin * stride;
        return place;
    }
};

// A view of the library, which is a pointer a component and then the stride, from component `first` on.
template <class View>
View view_of(const Place &place, std::size_t first = 0)
{
    View view;
    constexpr std::size_t pointers = sizeof view / sizeof(void *) - 1;
    std::memcpy(static_cast<void *>(&view), &place.component[first], pointers * sizeof(void *));
    view.stride = place.stride;
    return view;
}

template <class T>
const T *first_of(const Place &place)
{
    return reinterpret_cast<const T *>(place.component[0]);
}

struct Call {
    Place out;
    std::vector<Place> in;
    std::size_t count;
    testing::Random &random;  // for what a way of calling chooses
};

struct Function {
    std::string family, name;
    std::vector<Stream> inputs;
    Stream output;
    // One element: a pointer an input to its adjacent components.
    std::function<void(testing::Random &, void *const *inputs)> draw;
    // The first gives the bits that all others must give.
    std::vector<std::function<mw_status(const Call &)>> ways;
    std::function<Verdict(const void *const *inputs, const void *out, bool fuses)> judge;
    bool apart = false;  // results may not lie among the inputs, nor over them
};

using Functions = std::vector<Function>;

}  // namespace motorway::fuzz

#endif
