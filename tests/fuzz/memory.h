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
    // Of the streams one behind the other, or woven: in turn, element by element, all with the same stride.
    Memory(testing::Random &random, const std::vector<Stream> &streams, std::size_t count, bool woven)
        : random_(random), streams_(streams), count_(count)
    {
        std::size_t stride = 0;
        std::vector<std::size_t> first(streams.size());
        if (woven)
            for (std::size_t k = 0; k < streams.size(); ++k)
                if (streams[k].kind != Stream::shared) {
                    first[k] = stride;
                    stride += streams[k].components * streams[k].size + gap(streams[k]);
                }
        std::size_t end = gap({1, 1}) + stride * count;
        const std::size_t begin = end - stride * count;
        for (std::size_t k = 0; k < streams.size(); ++k)
            if (woven && streams[k].kind != Stream::shared)
                lay(streams[k], begin + first[k], stride);
            else
                lay_alone(streams[k], end);
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
    void write(std::size_t k, const char *elements) { copy(k, [&](char *here, std::size_t at, std::size_t size) {
        std::memcpy(here, elements + at, size);
    }); }
    void read(std::size_t k, char *elements) const { copy(k, [&](char *here, std::size_t at, std::size_t size) {
        std::memcpy(elements + at, here, size);
    }); }

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
    struct Offsets {
        std::array<std::size_t, most_components> component{};
        std::size_t stride = 0;
    };

    // Some bytes, mostly as many as keep numbers aligned.
    std::size_t gap(const Stream &stream)
    {
        return random_.chance(2) ? 0 : random_.chance(4) ? random_.below(40) : stream.size * random_.below(9);
    }

    // An element's components from `begin` on, adjacent and in order, or else anyhow.
    void lay(const Stream &stream, std::size_t begin, std::size_t stride)
    {
        Offsets offsets;
        offsets.stride = stride;
        for (std::size_t c = 0; c < stream.components; ++c)
            offsets.component[c] = begin + c * stream.size;
        if (stream.kind == Stream::apart && random_.chance(3))
            for (std::size_t c = stream.components; c > 1; --c)
                std::swap(offsets.component[c - 1], offsets.component[random_.below(c)]);
        offsets_.push_back(offsets);
    }

    void lay_alone(const Stream &stream, std::size_t &end)
    {
        const std::size_t count = stream.kind == Stream::shared ? 1 : count_;
        if (stream.kind == Stream::apart && random_.chance(3)) {  // an array a component
            Offsets offsets;
            offsets.stride = stream.size + (random_.chance(3) ? gap(stream) : 0);
            for (std::size_t c = 0; c < stream.components; ++c) {
                offsets.component[c] = end;
                end += offsets.stride * count + gap(stream);
            }
            offsets_.push_back(offsets);
            return;
        }
        if (stream.kind == Stream::shared || random_.chance(3))
            end = (end + 63) / 64 * 64;
        const std::size_t stride = stream.components * stream.size + (stream.kind == Stream::shared ? 0 : gap(stream));
        lay(stream, end, stride);
        end += stride * count + gap(stream);
    }

    template <class Use>
    void copy(std::size_t k, const Use &use) const
    {
        const Stream &stream = streams_[k];
        const std::size_t count = stream.kind == Stream::shared ? 1 : count_;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < stream.components; ++c)
                use(places_[k].component[c] + i * places_[k].stride, (i * stream.components + c) * stream.size, stream.size);
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
