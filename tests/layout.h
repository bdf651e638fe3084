// The ways to lay out an array of elements of several components in memory.
#ifndef MOTORWAY_TESTS_LAYOUT_H
#define MOTORWAY_TESTS_LAYOUT_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace motorway::testing {

// Where the components of element 0 are, by block and byte, the stride, and how long each block must be.
struct Placement {
    struct Place {
        std::size_t block, offset;
    };
    std::vector<Place> component;
    std::size_t stride = 0;
    std::vector<std::size_t> block_sizes;
};

class Layout {
public:
    // The components adjacent and in order, with `gap` bytes between elements.
    static Layout aos(std::size_t gap = 0) { return {Kind::aos, gap}; }
    // The same with the components in the opposite order.
    static Layout reversed(std::size_t gap = 0) { return {Kind::reversed, gap}; }
    // An array a component, each a block of its own, with `gap` bytes between elements.
    static Layout soa(std::size_t gap = 0) { return {Kind::soa, gap}; }
    // An array a component, one behind the other in the same block.
    static Layout rows() { return {Kind::rows, 0}; }
    // The components with even numbers adjacent in one block, those with odd numbers in another.
    static Layout split() { return {Kind::split, 0}; }

    // With the same gap.
    Layout with_components_adjacent() const { return aos(gap_); }

    Placement place(std::size_t components, std::size_t count, std::size_t scalar) const
    {
        Placement placement;
        placement.stride = gap_ + scalar * std::max<std::size_t>(1, adjacent(components));
        for (std::size_t k = 0; k < components; ++k)
            placement.component.push_back(position(k, components, count, scalar));
        for (const auto &[block, offset] : placement.component) {
            placement.block_sizes.resize(std::max(placement.block_sizes.size(), block + 1));
            const std::size_t size = count ? offset + (count - 1) * placement.stride + scalar : 0;
            placement.block_sizes[block] = std::max(placement.block_sizes[block], size);
        }
        return placement;
    }

    std::string name() const
    {
        static const char *const names[] = {"aos", "reversed", "soa", "rows", "split"};
        return std::string(names[static_cast<int>(kind_)]) + (gap_ ? "+" + std::to_string(gap_) : "");
    }

    // Every layout, with strides that keep the components aligned and some that do not. For three floats the
    // strides of aos are 12, 16, 32, 13 and 37 bytes.
    static std::vector<Layout> all(std::size_t components, std::size_t scalar)
    {
        return {aos(), aos(scalar), aos((components + 2) * scalar), aos(1), aos(25), reversed(scalar),
                soa(), soa(scalar), rows(), split()};
    }

private:
    enum class Kind { aos, reversed, soa, rows, split };

    Layout(Kind kind, std::size_t gap) : kind_(kind), gap_(gap) {}

    std::size_t adjacent(std::size_t components) const
    {
        switch (kind_) {
        case Kind::aos:
        case Kind::reversed: return components;
        case Kind::split: return (components + 1) / 2;
        default: return 1;
        }
    }

    Placement::Place position(std::size_t k, std::size_t components, std::size_t count, std::size_t scalar) const
    {
        switch (kind_) {
        case Kind::aos: return {0, k * scalar};
        case Kind::reversed: return {0, (components - 1 - k) * scalar};
        case Kind::soa: return {k, 0};
        case Kind::rows: return {0, k * count * scalar};
        default: return {k % 2, k / 2 * scalar};
        }
    }

    Kind kind_;
    std::size_t gap_;
};

}  // namespace motorway::testing

#endif
