// Memory between two pages that may not be touched. A block placed in it ends exactly at the page behind or starts
// exactly at the page in front, so that one byte read or written outside of it there ends the test.
#ifndef MOTORWAY_TESTS_GUARDED_BUFFER_H
#define MOTORWAY_TESTS_GUARDED_BUFFER_H

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace motorway::testing {

enum class Guard { after, before };  // which end of a block touches a forbidden page

class GuardedBuffer {
public:
    explicit GuardedBuffer(std::size_t capacity)
    {
        const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        capacity_ = (capacity + page - 1) / page * page;
        mapped_ = capacity_ + 2 * page;
        void *memory = mmap(nullptr, mapped_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED)
            throw std::runtime_error("mmap failed");
        mapping_ = static_cast<unsigned char *>(memory);
        begin_ = mapping_ + page;
        if (mprotect(begin_, capacity_, PROT_READ | PROT_WRITE) != 0)
            throw std::runtime_error("mprotect failed");
    }

    GuardedBuffer(GuardedBuffer &&other) noexcept
        : mapping_(std::exchange(other.mapping_, nullptr)), begin_(other.begin_), capacity_(other.capacity_),
          mapped_(other.mapped_)
    {
    }

    GuardedBuffer &operator=(GuardedBuffer &&) = delete;

    ~GuardedBuffer()
    {
        if (mapping_)
            munmap(mapping_, mapped_);
    }

    // A block of `size` bytes, `offset` bytes away from the guard. The same memory every time.
    unsigned char *place(std::size_t size, Guard guard, std::size_t offset = 0)
    {
        if (size + offset > capacity_)
            throw std::length_error("the block does not fit");
        return guard == Guard::before ? begin_ + offset : begin_ + capacity_ - size - offset;
    }

    template <class T>
    T *place_copy(const T *values, std::size_t count, Guard guard)
    {
        unsigned char *block = place(count * sizeof(T), guard);
        if (count)
            std::memcpy(block, values, count * sizeof(T));
        return reinterpret_cast<T *>(block);
    }

    unsigned char *begin() { return begin_; }
    unsigned char *end() { return begin_ + capacity_; }

private:
    unsigned char *mapping_ = nullptr, *begin_ = nullptr;
    std::size_t capacity_ = 0, mapped_ = 0;
};

}  // namespace motorway::testing

#endif
