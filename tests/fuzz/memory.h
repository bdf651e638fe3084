// Streams laid out in memory at random, in every way that a view can say, and what lies between them watched.
#ifndef MOTORWAY_TESTS_FUZZ_MEMORY_H
#define MOTORWAY_TESTS_FUZZ_MEMORY_H

#include <algorithm>
#include <vector>

#include "function.h"

namespace motorway::fuzz {

// Adjacent elements of adjacent components: how inputs and results are kept.
inline Place packed(const Stream &stream, char *first)
{
    Place place;
    place.stride = stream.components * stream.size;
    for (std::size_t k = 0; k < stream.components; ++k)
        place.component[k] = first + k * stream.size;
    return place;
}

class Memory {
public:
    static constexpr int nowhere = -1;

    // Of the streams one behind the other, or woven: in turn, element by element, all with the same stride. The last
    // one, of the results, may lie over another, element over element and number over number, in any order.
    Memory(testing::Random &random, const std::vector<Stream> &streams, std::size_t count, bool woven, int over)
        : random_(random), streams_(streams), count_(count), offsets_(streams.size())
    {
        const std::size_t last = streams.size() - 1, placed = over == nowhere ? streams.size() : last;
        std::vector<std::size_t> room, first(streams.size());
        for (const Stream &stream : streams)
            room.push_back(stream.components);
        if (over != nowhere)
            room[index(over)] = std::max(room[index(over)], streams[last].components);
        std::size_t stride = 0;
        for (std::size_t k = 0; k < placed && woven; ++k)
            if (streams[k].kind != Stream::shared) {
                first[k] = stride;
                stride += room[k] * streams[k].size + gap(streams[k]);
            }
        const std::size_t begin = gap({1, 1});
        std::size_t end = begin + stride * count;
        for (std::size_t k = 0; k < placed; ++k) {
            const bool lies_under = over != nowhere && k == index(over);
            const bool whole = lies_under && streams[last].kind != Stream::apart;
            const Slots slots = woven && streams[k].kind != Stream::shared
                                    ? adjacent(begin + first[k], room[k], streams[k].size, stride)
                                    : alone(streams[k], room[k], whole, end);
            offsets_[k] = take(slots, streams[k]);
            if (lies_under)
                offsets_[last] = random.chance(2) && streams[k].components == streams[last].components
                                     ? offsets_[k]
                                     : take(slots, streams[last]);
        }
        bytes_.resize(end + 64);
        for (char &byte : bytes_)
            byte = static_cast<char>(random_.bits());
        for (std::size_t k = 0; k < streams.size(); ++k) {
            places_.emplace_back();
            places_[k].stride = offsets_[k].stride;
            for (std::size_t c = 0; c < streams[k].components; ++c)
                places_[k].component[c] = bytes_.data() + offsets_[k].component[c];
        }
    }

    const Place &place(std::size_t k) const { return places_[k]; }

    // Elements that are kept packed into stream k, and back.
    void write(std::size_t k, const char *elements)
    {
        copy(k, [&](char *here, std::size_t at, std::size_t size) { std::memcpy(here, elements + at, size); });
    }
    void read(std::size_t k, char *elements) const
    {
        copy(k, [&](char *here, std::size_t at, std::size_t size) { std::memcpy(elements + at, here, size); });
    }

    void remember() { before_ = bytes_; }
    // Whether nothing has changed since but what belongs to stream k.
    bool changed_only(std::size_t k)
    {
        copy(k, [&](char *here, std::size_t, std::size_t size) {
            std::memcpy(&before_[static_cast<std::size_t>(here - bytes_.data())], here, size);
        });
        return before_ == bytes_;
    }

private:
    struct Slots {
        std::vector<std::size_t> number;  // where those of the first element are
        std::size_t stride;
    };
    struct Offsets {
        std::array<std::size_t, most_components> component{};
        std::size_t stride = 0;
    };

    static std::size_t index(int k) { return static_cast<std::size_t>(k); }

    // Some bytes, mostly as many as keep numbers aligned.
    std::size_t gap(const Stream &stream)
    {
        return random_.chance(2) ? 0 : random_.chance(4) ? random_.below(40) : stream.size * random_.below(9);
    }

    static Slots adjacent(std::size_t begin, std::size_t room, std::size_t size, std::size_t stride)
    {
        Slots slots{{}, stride};
        for (std::size_t k = 0; k < room; ++k)
            slots.number.push_back(begin + k * size);
        return slots;
    }

    // Numbers that are adjacent, with or without something between elements; or an array each.
    Slots alone(const Stream &stream, std::size_t room, bool whole, std::size_t &end)
    {
        const std::size_t count = stream.kind == Stream::shared ? 1 : count_;
        if (stream.kind == Stream::apart && !whole && random_.chance(3)) {
            Slots slots{{}, stream.size + (random_.chance(3) ? gap(stream) : 0)};
            for (std::size_t k = 0; k < room; ++k) {
                slots.number.push_back(end);
                end += slots.stride * count + gap(stream);
            }
            return slots;
        }
        if (stream.kind == Stream::shared || random_.chance(3))
            end = (end + 63) / 64 * 64;
        const std::size_t stride = room * stream.size + (stream.kind == Stream::shared ? 0 : gap(stream));
        const Slots slots = adjacent(end, room, stream.size, stride);
        end += stride * count + gap(stream);
        return slots;
    }

    // An element's components in order, or else anyhow.
    Offsets take(const Slots &slots, const Stream &stream)
    {
        std::vector<std::size_t> numbers = slots.number;
        if (stream.kind == Stream::apart && random_.chance(3))
            for (std::size_t k = numbers.size(); k > 1; --k)
                std::swap(numbers[k - 1], numbers[random_.below(k)]);
        Offsets offsets;
        offsets.stride = slots.stride;
        std::copy_n(numbers.begin(), stream.components, offsets.component.begin());
        return offsets;
    }

    template <class Use>
    void copy(std::size_t k, const Use &use) const
    {
        const Stream &stream = streams_[k];
        const std::size_t count = stream.kind == Stream::shared ? 1 : count_;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < stream.components; ++c)
                use(places_[k].component[c] + i * places_[k].stride, (i * stream.components + c) * stream.size,
                    stream.size);
    }

    testing::Random &random_;
    std::vector<Stream> streams_;
    std::size_t count_;
    std::vector<Offsets> offsets_;
    std::vector<char> bytes_, before_;
    std::vector<Place> places_;
};

}  // namespace motorway::fuzz

#endif
