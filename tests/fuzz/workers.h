// A process for each instruction set, since a process has one. They share the inputs and show their results.
#ifndef MOTORWAY_TESTS_FUZZ_WORKERS_H
#define MOTORWAY_TESTS_FUZZ_WORKERS_H

#include <string>
#include <vector>

#include <sys/types.h>

#include "round.h"

namespace motorway::fuzz {

struct Request {
    std::uint64_t function, count, seed;
};

class Workers {
public:
    // Those of the instruction sets named that can run here.
    Workers(const Functions &functions, const std::vector<std::string> &isas);
    ~Workers();
    Workers(const Workers &) = delete;
    Workers &operator=(const Workers &) = delete;

    std::size_t size() const { return workers_.size(); }
    const std::string &isa(std::size_t k) const { return workers_[k].isa; }
    bool fuses(std::size_t k) const { return isa(k) != "scalar" && isa(k) != "sse2"; }

    Batch &batch() { return shared_->batch; }
    const Results &results(std::size_t k) const { return shared_->results[k]; }

    // All of them, on the batch. A process that has ended is an outcome too.
    std::vector<Outcome> run(const Request &request);

private:
    static constexpr std::size_t most_workers = 8;
    struct Shared {
        Batch batch;
        Results results[most_workers];
    };
    struct Worker {
        std::string isa;
        pid_t process;
        int requests, outcomes;  // pipes
    };

    bool start(const Functions &functions, const std::string &isa);
    void serve(const Functions &functions, int requests, int outcomes, Results &results);

    Shared *shared_;
    std::vector<Worker> workers_;
};

}  // namespace motorway::fuzz

#endif
