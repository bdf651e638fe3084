/* A line of progress on a terminal, for work that takes more than two seconds. */
#ifndef MOTORWAY_TOOL_PROGRESS_H
#define MOTORWAY_TOOL_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <string>

namespace motorway::tool {

class Progress {
public:
    /* `label` such as "posing frame"; written to the standard error, and only if that is a terminal. */
    Progress(std::string label, std::size_t total);
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;
    ~Progress(); /* wipes the line */

    void step();

private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    std::size_t total_, done_ = 0;
    bool on_terminal_, shown_ = false;
    Clock::time_point next_;
};

} // namespace motorway::tool

#endif
