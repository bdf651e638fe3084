// What was found: each kind once, with the worst of its kind.
#ifndef MOTORWAY_TESTS_FUZZ_FINDINGS_H
#define MOTORWAY_TESTS_FUZZ_FINDINGS_H

#include <map>
#include <string>
#include <utility>

#include "function.h"

namespace motorway::fuzz {

// One element of one batch, and where it came from.
struct Case {
    const Function *function;
    std::string isa, again;
    std::size_t element;
    std::vector<const void *> inputs;
    const void *out;
};

class Findings {
public:
    // The first of a kind is printed at once, and so is one that is ten times worse than those before.
    void found(const Case &at, const std::string &what, double error, double bound, const Verdict &verdict);
    // Whatever its size, the largest of each part of each function is kept.
    void measured(const Function &function, bool fuses, const Finding &finding);

    std::size_t kinds() const { return kinds_.size(); }
    void print_kinds() const;
    void print_errors() const;

private:
    struct Kind {
        std::size_t count = 0;
        double worst = 0;
        std::string text;
    };
    struct Error {
        double worst[2] = {0, 0};  // apart, fused
        double bound[2] = {0, 0};
    };
    std::map<std::string, Kind> kinds_;
    std::map<std::pair<std::string, std::string>, Error> errors_;
};

}  // namespace motorway::fuzz

#endif
