// Arrays for the controls and knots of a motion that is made or edited. Each ends, or begins, at a page that may not
// be touched, and what lies around it is watched.
#ifndef MOTORWAY_TESTS_MOTION_ROOM_H
#define MOTORWAY_TESTS_MOTION_ROOM_H

#include <cstddef>
#include <cstring>

#include "api.h"
#include "guarded_buffer.h"

namespace motorway::testing {

template <class T>
class Room {
public:
    using Motor = typename api<T>::motor;

    Room(std::size_t controls, std::size_t knots, Guard guard = Guard::after)
        : control_memory_(controls * sizeof(Motor)), knot_memory_(knots * sizeof(T)),
          arrays{reinterpret_cast<Motor *>(control_memory_.place(controls * sizeof(Motor), guard)), controls,
                 reinterpret_cast<T *>(knot_memory_.place(knots * sizeof(T), guard)), knots}
    {
        std::memset(control_memory_.begin(), pattern, control_bytes());
        std::memset(knot_memory_.begin(), pattern, knot_bytes());
    }
    explicit Room(const typename api<T>::motion &asked, Guard guard = Guard::after)
        : Room(asked.control_count, asked.knot_count, guard)
    {
    }

    // Whether nothing has been written, or nothing but the arrays.
    bool is_untouched() { return untouched(control_memory_, 0, nullptr) && untouched(knot_memory_, 0, nullptr); }
    bool is_untouched_elsewhere()
    {
        return untouched(control_memory_, arrays.control_capacity * sizeof(Motor), arrays.controls) &&
               untouched(knot_memory_, arrays.knot_capacity * sizeof(T), arrays.knots);
    }

private:
    static constexpr unsigned char pattern = 0xa7;

    std::size_t control_bytes() { return static_cast<std::size_t>(control_memory_.end() - control_memory_.begin()); }
    std::size_t knot_bytes() { return static_cast<std::size_t>(knot_memory_.end() - knot_memory_.begin()); }

    static bool untouched(GuardedBuffer &memory, std::size_t written, const void *where)
    {
        const auto *first = static_cast<const unsigned char *>(where);
        for (const unsigned char *byte = memory.begin(); byte < memory.end(); ++byte)
            if (*byte != pattern && !(written && byte >= first && byte < first + written))
                return false;
        return true;
    }

    GuardedBuffer control_memory_, knot_memory_;

public:
    const typename api<T>::motion_arrays arrays;
};

}  // namespace motorway::testing

#endif
