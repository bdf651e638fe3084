#include "cpu_name.h"

#include <fstream>

#ifdef __APPLE__
#include <sys/sysctl.h>
#endif

namespace motorway::tool {

#ifdef __APPLE__

std::string cpu_name()
{
    char name[256];
    std::size_t size = sizeof name;
    return sysctlbyname("machdep.cpu.brand_string", name, &size, nullptr, 0) == 0 ? name : "unknown";
}

#else

/* Linux says "model name" on x86; ARM kernels mostly say nothing that a person would know. */
std::string cpu_name()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

#endif

} // namespace motorway::tool
