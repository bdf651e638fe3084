// What is found out about one element of a result.
#ifndef MOTORWAY_TESTS_FUZZ_VERDICT_H
#define MOTORWAY_TESTS_FUZZ_VERDICT_H

#include <array>
#include <cstddef>
#include <vector>

#include "wide.h"

namespace motorway::fuzz {

struct Finding {
    const char *what;     // which part of the result, or what was required of it
    double error, bound;  // in epsilons
    bool wrong() const { return !(error <= bound); }
};

// Bounds in the documentation are the worst of some ten thousand inputs. Here there are many millions.
constexpr double margin = 1.5;

class Verdict {
public:
    Verdict() = default;
    // By what factor scales must stay below the largest number to be judged, and how much more of the smallest is
    // lost.
    Verdict(long double headroom, long double footroom) : headroom_(headroom), footroom_(footroom) {}

    // That `count` numbers are the right ones: the length of their difference in epsilons of `scale`, beside what
    // underflow makes: `lost` of the smallest numbers. Where what is right nearly overflows, or its terms do, it may
    // be anything.
    template <class T>
    void near(const char *what, const T *numbers, const Wide<T> *right, std::size_t count, Wide<T> scale, double bound,
              Wide<T> lost = 4)
    {
        using R = Wide<T>;
        for (std::size_t k = 0; k < count && right_.size() < 16; ++k)
            right_.push_back(static_cast<long double>(right[k]));
        if (scale * static_cast<R>(headroom_) > largest<T>())
            return;
        R sum = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const R difference = abs(R(R(numbers[k]) - right[k]));
            if (!(difference <= lost * static_cast<R>(footroom_) * smallest<T>()))
                sum += difference * difference;
        }
        const R error = sum == 0 ? R(0) : scale == 0 ? largest<T>() : R(sqrt(sum) / (epsilon<T>() * scale));
        findings_.push_back({what, static_cast<double>(error), margin * bound});
    }

    // A number that is to be no larger than the bound.
    void at_most(const char *what, double number, double bound) { findings_.push_back({what, number, bound}); }
    void require(const char *what, bool holds) { findings_.push_back({what, holds ? 0.0 : 2.0, 1.0}); }

    const std::vector<Finding> &findings() const { return findings_; }
    const std::vector<long double> &right() const { return right_; }

    // The larger, the worse.
    double badness() const
    {
        double worst = 0;
        for (const Finding &finding : findings_) {
            if (finding.error == 0)
                continue;
            const double over = finding.error - finding.bound;
            const double badness = !finding.wrong()   ? finding.error / finding.bound
                                   : std::isnan(over) ? HUGE_VAL
                                                      : 1 + over;
            worst = badness <= worst ? worst : badness;
        }
        return worst;
    }

    // Of two results that are both right.
    static const Verdict &better(const Verdict &a, const Verdict &b) { return b.badness() < a.badness() ? b : a; }

private:
    long double headroom_ = 16, footroom_ = 1;
    std::vector<Finding> findings_;
    std::vector<long double> right_;
};

}  // namespace motorway::fuzz

#endif
