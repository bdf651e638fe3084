// Every function of the library on inputs at random, half of them at the edge of something, on every instruction set,
// held to what is right and to its own bits. tools/fuzz starts it.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include "families.h"
#include "findings.h"
#include "workers.h"

namespace motorway::fuzz {
namespace {

struct Options {
    double seconds = 60;
    std::uint64_t seed = 1;
    std::uint64_t round = 0;  // the only one; else all, from 1 on
    std::string only;         // a family, or a part of a function's name
    std::vector<std::string> isas;
    bool errors = false;
};

// A family; or, if there is none of that name, all functions with it in their names.
Functions meant(const Functions &all, const std::string &only)
{
    Functions family, named;
    for (const Function &function : all) {
        if (function.family == only)
            family.push_back(function);
        if (function.name.find(only) != std::string::npos)
            named.push_back(function);
    }
    return family.empty() ? named : family;
}

class Fuzzer {
public:
    Fuzzer(const Options &options, Functions functions)
        : options_(options), functions_(std::move(functions)), workers_(functions_, options.isas)
    {
        again_ = "--seed " + std::to_string(options.seed);
        if (!options.only.empty())
            again_ += " --only '" + options.only + "'";
        again_ += " --round ";
    }

    std::size_t isas() const { return workers_.size(); }
    const Findings &findings() const { return findings_; }
    double elements() const { return elements_; }
    bool alive() const { return alive_; }

    void round(std::uint64_t number)
    {
        testing::Random random(options_.seed * 0x9e3779b97f4a7c15u + number);
        const std::size_t chosen = random.below(functions_.size());
        const Function &function = functions_[chosen];
        number_ = number;
        const std::size_t count = 1 + random.below(random.chance(3) ? 8 : most_elements);
        draw(function, count, random);
        const std::vector<Outcome> outcomes = workers_.run({chosen, count, random.bits()});
        for (std::size_t k = 0; k < outcomes.size(); ++k)
            if (outcomes[k].element >= 0) {
                findings_.found(at(function, k, static_cast<std::size_t>(outcomes[k].element)), outcomes[k].fault, 0,
                                -1, {});
                alive_ = alive_ && !std::strstr(outcomes[k].fault, "the process ended");
            }
        for (const bool fuses : {true, false})
            judge(function, count, fuses);
        elements_ += static_cast<double>(count);
    }

private:
    void draw(const Function &function, std::size_t count, testing::Random &random)
    {
        char unused[most_inputs][most_components * sizeof(double)];
        for (std::size_t i = 0; i < count; ++i) {
            void *inputs[most_inputs];
            for (std::size_t k = 0; k < function.inputs.size(); ++k) {
                const Stream &stream = function.inputs[k];
                const bool drawn = stream.kind == Stream::shared && i > 0;
                inputs[k] = drawn ? unused[k] : workers_.batch().inputs[k] + i * stream.components * stream.size;
            }
            function.draw(random, inputs);
        }
    }

    Case at(const Function &function, std::size_t worker, std::size_t i)
    {
        Case place{&function, workers_.isa(worker), again_ + std::to_string(number_), i, {}, nullptr};
        for (std::size_t k = 0; k < function.inputs.size(); ++k) {
            const Stream &stream = function.inputs[k];
            const std::size_t element = stream.kind == Stream::shared ? 0 : i;
            place.inputs.push_back(workers_.batch().inputs[k] + element * stream.components * stream.size);
        }
        place.out = workers_.results(worker).elements + i * function.output.components * function.output.size;
        return place;
    }

    // The instruction sets of a class: their bits, and what the first of them is.
    void judge(const Function &function, std::size_t count, bool fuses)
    {
        std::vector<std::size_t> workers;
        for (std::size_t k = 0; k < workers_.size(); ++k)
            if (workers_.fuses(k) == fuses)
                workers.push_back(k);
        const std::size_t components = function.output.components, size = function.output.size;
        for (std::size_t i = 0; i < count && !workers.empty(); ++i) {
            const Case first = at(function, workers[0], i);
            const Verdict verdict = function.judge(first.inputs.data(), first.out, fuses);
            for (const Finding &finding : verdict.findings()) {
                findings_.measured(function, fuses, finding);
                if (finding.wrong())
                    findings_.found(first, finding.what, finding.error, finding.bound, verdict);
            }
            const char *const one = static_cast<const char *>(first.out);
            for (std::size_t k = 1; k < workers.size(); ++k) {
                const Case other = at(function, workers[k], i);
                for (std::size_t c = 0; c < components; ++c)
                    if (!same_number(one + c * size, static_cast<const char *>(other.out) + c * size, size)) {
                        findings_.found(other, "other bits than on " + first.isa, 0, -1, verdict);
                        break;
                    }
            }
        }
    }

    Options options_;
    Functions functions_;
    Workers workers_;
    Findings findings_;
    std::string again_;  // the options that come to the same batch
    std::uint64_t number_ = 0;
    double elements_ = 0;
    bool alive_ = true;
};

[[noreturn]] void explain(const char *wrong)
{
    std::printf(
        "%s%smotorway_fuzz [--minutes N | --seconds N] [--seed S] [--round R] [--only FAMILY] [--isa NAME] "
        "[--errors]\n",
        wrong, *wrong ? "\n" : "");
    std::exit(*wrong ? 2 : 0);
}

Options options_of(int argc, char **argv)
{
    Options options;
    for (int k = 1; k < argc; ++k) {
        const std::string name = argv[k];
        if (name == "--help" || name == "-h")
            explain("");
        if (name == "--errors") {
            options.errors = true;
            continue;
        }
        if (k + 1 == argc)
            explain(("there is no option " + name + ", or it lacks its value").c_str());
        const char *const value = argv[++k];
        if (name == "--minutes")
            options.seconds = 60 * std::atof(value);
        else if (name == "--seconds")
            options.seconds = std::atof(value);
        else if (name == "--seed")
            options.seed = std::strtoull(value, nullptr, 0);
        else if (name == "--round")
            options.round = std::strtoull(value, nullptr, 0);
        else if (name == "--only")
            options.only = value;
        else if (name == "--isa")
            options.isas.push_back(value);
        else
            explain(("there is no option " + name).c_str());
    }
    if (options.isas.empty()) {
        std::istringstream compiled(MOTORWAY_TEST_ISAS);
        for (std::string isa; compiled >> isa;)
            options.isas.push_back(isa);
    }
    return options;
}

int fuzz(const Options &options)
{
    using Clock = std::chrono::steady_clock;
    const Functions functions = options.only.empty() ? all_functions() : meant(all_functions(), options.only);
    if (functions.empty())
        explain(("no function is called " + options.only).c_str());
    Fuzzer fuzzer(options, functions);
    if (fuzzer.isas() == 0)
        explain("none of these instruction sets can run here");
    std::printf("%zu functions on %zu instruction sets, seed %llu\n", functions.size(), fuzzer.isas(),
                static_cast<unsigned long long>(options.seed));
    const Clock::time_point start = Clock::now();
    double shown = 0, seconds = 0;
    std::uint64_t round = options.round ? options.round : 1;
    for (; seconds < options.seconds && fuzzer.alive(); ++round) {
        fuzzer.round(round);
        if (options.round)
            break;
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (seconds - shown >= 5) {
            shown = seconds;
            std::printf("%6.0f s  %.2f million elements, %zu kinds of finds\n", seconds, fuzzer.elements() / 1e6,
                        fuzzer.findings().kinds());
            std::fflush(stdout);
        }
    }
    fuzzer.findings().print_kinds();
    if (options.errors)
        fuzzer.findings().print_errors();
    std::printf("\n%s: %.2f million elements, %zu kinds of finds\n", fuzzer.findings().kinds() ? "FAILED" : "Clean",
                fuzzer.elements() / 1e6, fuzzer.findings().kinds());
    return fuzzer.findings().kinds() ? 1 : 0;
}

}  // namespace
}  // namespace motorway::fuzz

int main(int argc, char **argv) { return motorway::fuzz::fuzz(motorway::fuzz::options_of(argc, argv)); }
