#include "workers.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace motorway::fuzz {
namespace {

// As many bytes as were asked for, unless the other end is closed.
template <class T>
bool receive(int from, T &message)
{
    char *at = reinterpret_cast<char *>(&message);
    for (std::size_t left = sizeof message; left > 0;) {
        const ssize_t size = read(from, at, left);
        if (size <= 0)
            return false;
        at += size;
        left -= static_cast<std::size_t>(size);
    }
    return true;
}

template <class T>
bool send(int to, const T &message)
{
    return write(to, &message, sizeof message) == static_cast<ssize_t>(sizeof message);
}

}  // namespace

Workers::Workers(const Functions &functions, const std::vector<std::string> &isas)
{
    signal(SIGPIPE, SIG_IGN);
    void *const memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        throw std::runtime_error("no memory to share with other processes");
    shared_ = static_cast<Shared *>(memory);
    for (const std::string &isa : isas)
        if (!start(functions, isa))
            std::printf("%s cannot run here\n", isa.c_str());
}

Workers::~Workers()
{
    for (const Worker &worker : workers_) {
        close(worker.requests);
        close(worker.outcomes);
        waitpid(worker.process, nullptr, 0);
    }
    munmap(shared_, sizeof(Shared));
}

// The parent never calls the library on a batch: what it chose would be chosen for its children as well.
bool Workers::start(const Functions &functions, const std::string &isa)
{
    int requests[2], outcomes[2];
    if (workers_.size() == most_workers || pipe(requests) != 0 || pipe(outcomes) != 0)
        throw std::runtime_error("no pipe to another process");
    std::fflush(stdout);
    const pid_t process = fork();
    if (process < 0)
        throw std::runtime_error("no other process");
    if (process == 0) {
        close(requests[1]);
        close(outcomes[0]);
        for (const Worker &other : workers_) {
            close(other.requests);
            close(other.outcomes);
        }
        setenv("MOTORWAY_ISA", isa.c_str(), 1);
        const char runs = mw_isa() != nullptr;
        if (send(outcomes[1], runs) && runs)
            serve(functions, requests[0], outcomes[1], shared_->results[workers_.size()]);
        _exit(0);
    }
    close(requests[0]);
    close(outcomes[1]);
    char runs = 0;
    if (receive(outcomes[0], runs) && runs) {
        workers_.push_back({isa, process, requests[1], outcomes[0]});
        return true;
    }
    close(requests[1]);
    close(outcomes[0]);
    waitpid(process, nullptr, 0);
    return false;
}

void Workers::serve(const Functions &functions, int requests, int outcomes, Results &results)
{
    Request request;
    while (receive(requests, request))
        if (!send(outcomes,
                  fuzz::run(functions[request.function], shared_->batch, request.count, request.seed, results)))
            return;
}

std::vector<Outcome> Workers::run(const Request &request)
{
    for (const Worker &worker : workers_)
        send(worker.requests, request);
    std::vector<Outcome> outcomes(workers_.size());
    for (std::size_t k = 0; k < workers_.size(); ++k)
        if (!receive(workers_[k].outcomes, outcomes[k])) {
            int status = 0;
            waitpid(workers_[k].process, &status, 0);
            outcomes[k].element = 0;
            std::snprintf(outcomes[k].fault, sizeof outcomes[k].fault, "the process ended, by signal %d",
                          WIFSIGNALED(status) ? WTERMSIG(status) : 0);
        }
    return outcomes;
}

}  // namespace motorway::fuzz
