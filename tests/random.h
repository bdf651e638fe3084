// A small deterministic source of random numbers (splitmix64), the same on every platform, so that a failure that
// prints its seed can be repeated.
#ifndef MOTORWAY_TESTS_RANDOM_H
#define MOTORWAY_TESTS_RANDOM_H

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace motorway::testing {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits()
    {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(bits() % bound); }
    bool chance(std::size_t one_in) { return below(one_in) == 0; }

    // In [low, high).
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

    // With either sign and a magnitude in [low, high), even on the logarithmic scale.
    double magnitude(double low, double high)
    {
        const double size = low * std::exp(uniform(0, std::log(high / low)));
        return chance(2) ? -size : size;
    }

private:
    std::uint64_t state_;
};

}  // namespace motorway::testing

#endif
