#include "progress.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

namespace motorway::tool {

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)), total_(total), on_terminal_(isatty(STDERR_FILENO) != 0),
      next_(Clock::now() + std::chrono::seconds(2))
{
}

Progress::~Progress()
{
    if (shown_)
        std::fputs("\r\033[K", stderr);
}

void Progress::step()
{
    ++done_;
    if (!on_terminal_ || Clock::now() < next_)
        return;
    std::fprintf(stderr, "\r%s %zu of %zu", label_.c_str(), done_, total_);
    std::fflush(stderr);
    shown_ = true;
    next_ = Clock::now() + std::chrono::milliseconds(100);
}

} // namespace motorway::tool
