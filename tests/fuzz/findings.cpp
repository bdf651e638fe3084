#include "findings.h"

#include <cstdio>
#include <limits>

namespace motorway::fuzz {
namespace {

std::string numbers_text(const void *numbers, const Stream &stream)
{
    std::string text;
    for (std::size_t k = 0; k < stream.components; ++k) {
        char number[64];
        const double value = stream.size == sizeof(float) ? static_cast<double>(static_cast<const float *>(numbers)[k])
                                                          : static_cast<const double *>(numbers)[k];
        std::snprintf(number, sizeof number, "%s%a", k ? ", " : "", value);
        text += number;
    }
    return text;
}

std::string right_text(const Verdict &verdict)
{
    std::string text;
    for (const long double value : verdict.right()) {
        char number[64];
        std::snprintf(number, sizeof number, "%s%.13La", text.empty() ? "" : ", ", value);
        text += number;
    }
    return text;
}

std::string describe(const Case &at, const std::string &what, double error, double bound, const Verdict &verdict)
{
    char line[640];
    std::snprintf(line, sizeof line, "FOUND %s on %s: %s", at.function->name.c_str(), at.isa.c_str(), what.c_str());
    std::string text = line;
    if (bound >= 0) {
        std::snprintf(line, sizeof line, " is off by %.4g epsilons, and %.3g are allowed", error, bound);
        text += line;
    }
    for (std::size_t k = 0; k < at.inputs.size(); ++k)
        text += "\n    input " + std::to_string(k) + ": " + numbers_text(at.inputs[k], at.function->inputs[k]);
    text += "\n    result:  " + numbers_text(at.out, at.function->output);
    if (!verdict.right().empty())
        text += "\n    right:   " + right_text(verdict);
    return text + "\n    again:   ./tools/fuzz " + at.again + "   (element " + std::to_string(at.element) + ")\n";
}

}  // namespace

void Findings::found(const Case &at, const std::string &what, double error, double bound, const Verdict &verdict)
{
    Kind &kind = kinds_[at.function->name + " " + at.isa + " " + what.substr(0, what.find(':'))];
    const bool first = kind.count++ == 0, worse = error > 10 * kind.worst;
    if (!first && !(error > kind.worst))
        return;
    kind.worst = error;
    kind.text = describe(at, what, error, bound, verdict);
    if (first || worse) {
        std::printf("%s", kind.text.c_str());
        std::fflush(stdout);
    }
}

void Findings::measured(const Function &function, bool fuses, const Finding &finding)
{
    Error &error = errors_[{function.name, finding.what}];
    if (finding.error > error.worst[fuses])
        error.worst[fuses] = finding.error;
    error.bound[fuses] = finding.bound;
}

void Findings::print_kinds() const
{
    for (const auto &[name, kind] : kinds_)
        std::printf("\n%zu times, the worst:\n%s", kind.count, kind.text.c_str());
}

void Findings::print_errors() const
{
    std::printf("\n%-44s %-14s %10s %10s\n", "the largest errors, in epsilons", "of", "fused", "not fused");
    for (const auto &[key, error] : errors_)
        std::printf("%-44s %-14s %10.3g %10.3g\n", key.first.c_str(), key.second.c_str(), error.worst[1],
                    error.worst[0]);
}

}  // namespace motorway::fuzz
