// A heap block of so many numbers of which none is initialised.
#ifndef MOTORWAY_TESTS_MEMCHECK_ROOM_H
#define MOTORWAY_TESTS_MEMCHECK_ROOM_H

#include "touch.h"

namespace motorway::memcheck {

template <class T>
class Room {
public:
    explicit Room(std::size_t count) : count_(count), numbers_(static_cast<T *>(std::malloc(count * sizeof(T)))) {}
    ~Room() { std::free(numbers_); }
    Room(const Room &) = delete;
    Room &operator=(const Room &) = delete;

    T *get() { return numbers_; }
    std::size_t count() const { return count_; }
    void touch(std::size_t count) const { memcheck::touch(numbers_, count * sizeof(T)); }
    void touch() const { touch(count_); }

private:
    std::size_t count_;
    T *numbers_;
};

}  // namespace motorway::memcheck

#endif
