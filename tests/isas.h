// The instruction sets that are compiled in, widest first as the build lists them, and which of them run here.
#ifndef MOTORWAY_TESTS_ISAS_H
#define MOTORWAY_TESTS_ISAS_H

#include <sstream>
#include <string>
#include <vector>

#include "dispatch.h"
#include "motorway_views.h"

namespace motorway::testing {

// From the build: "scalar sse2 avx2", say. Tests are of those that run; isa_test.cpp names the others, once.
inline std::vector<std::string> compiled_isas()
{
    std::istringstream text(MOTORWAY_TEST_ISAS);
    std::vector<std::string> isas;
    for (std::string isa; text >> isa;)
        isas.push_back(isa);
    return isas;
}

inline bool fuses(const std::string &isa) { return isa != "scalar" && isa != "sse2"; }

// Uses one instruction set until the end of the scope, and then the one that was in use.
class ScopedIsa {
public:
    explicit ScopedIsa(const std::string &isa) : previous_(mw_isa()), runs_(select_isa(isa.c_str())) {}
    ~ScopedIsa() { select_isa(previous_.c_str()); }
    ScopedIsa(const ScopedIsa &) = delete;
    ScopedIsa &operator=(const ScopedIsa &) = delete;

    bool runs() const { return runs_; }

private:
    std::string previous_;
    bool runs_;
};

inline std::vector<std::string> running_isas()
{
    std::vector<std::string> isas;
    for (const std::string &isa : compiled_isas())
        if (ScopedIsa(isa).runs())
            isas.push_back(isa);
    return isas;
}

}  // namespace motorway::testing

#endif
