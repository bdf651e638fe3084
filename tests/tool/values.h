/* Values as the bytes of a file. */
#ifndef MOTORWAY_TESTS_VALUES_H
#define MOTORWAY_TESTS_VALUES_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace motorway::tool {

// Bytes of a value, as a PLY file of either order has them.
template <class T> std::string bytes(T value, bool big_endian)
{
    std::string text(sizeof value, '\0');
    std::memcpy(text.data(), &value, sizeof value);
    const std::uint16_t probe = 1;
    const bool machine_is_little = *reinterpret_cast<const unsigned char *>(&probe) == 1;
    if (big_endian == machine_is_little)
        std::reverse(text.begin(), text.end());
    return text;
}

} // namespace motorway::tool

#endif
